#include "Module/Scenes/ReferenceMixture.h"

#include "Frame/PropertyTransferFunction.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace varimarch;

ReferenceMixture::ReferenceMixture(MapperScene& scene)
  : property(scene.volume->GetProperty())
  , geometry(VolumeGeometryOf(scene.image, scene.volume))
  , isNearest(this->property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
{
  vtkDataArray* const scalars = scene.image->GetPointData()->GetScalars();
  for (int i = 0; i < scalars->GetNumberOfComponents(); ++i)
  {
    const bool hasFunction = i == 0 || this->property->GetIndependentComponents();
    Component component{ {}, TransferFunctionOf(this->property, hasFunction ? i : 0), 0.0 };
    for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); ++voxel)
    {
      component.voxels.push_back(scalars->GetComponent(voxel, i));
    }
    const auto [least, most] =
      std::minmax_element(component.voxels.begin(), component.voxels.end());
    component.range = *most - *least;
    this->components.push_back(component);
  }
  this->largestColor = scalars->GetDataTypeSize() <= 2 ? scalars->GetDataTypeMax() : 1.0;
}

// Without interpolation the reference's cell is a voxel's box, and begins half a voxel before it.
ReferenceMixture::Sample ReferenceMixture::SampleAt(int component, glm::dvec3 positionGrid) const
{
  const ScalarGrid<double> grid(
    this->components[std::size_t(component)].voxels.data(), this->geometry.dimensions);
  const glm::dvec3 last(this->geometry.dimensions - 1);
  const glm::dvec3 position =
    this->isNearest ? glm::clamp(glm::floor(positionGrid), glm::dvec3(0.0), last) : positionGrid;
  return { grid.Value(position), grid.Gradient(position) };
}

// The opacity of a unit distance is multiplied by that of the gradient, in differences per mean
// spacing, which saturates at a quarter of the range.
double ReferenceMixture::ExtinctionOf(int component, const Sample& sample) const
{
  const Component& one = this->components[std::size_t(component)];
  if (!this->property->HasGradientOpacity(component))
  {
    return one.function.Extinction(sample.value);
  }
  const double magnitude = 2.0 * glm::length(this->geometry.gradientFactors * sample.gradient);
  const double most = 0.25 * (one.range > 0.0 ? one.range : 1.0);
  const double factor = std::clamp(
    this->property->GetGradientOpacity(component)->GetValue(std::min(magnitude, most)), 0.0, 1.0);
  return -std::log1p(-factor * one.function.Opacity(sample.value)) /
    this->property->GetScalarOpacityUnitDistance(component);
}

glm::dvec3 ReferenceMixture::Lit(
  int component, glm::dvec3 rgb, glm::dvec3 gradient, const Ray& rayGrid) const
{
  if (!this->property->GetShade())
  {
    return rgb;
  }
  const glm::dvec3 normal = this->geometry.WorldFromGridNormal() * gradient;
  const glm::dvec3 toEye = this->geometry.WorldFromGridDirection() * rayGrid.direction;
  const double lengths = glm::length(normal) * glm::length(toEye);
  const double facing = lengths > 0.0 ? std::abs(glm::dot(normal, toEye)) / lengths : 0.0;
  const double highlight = facing > 0.0 ? this->property->GetSpecular(component) *
      std::pow(facing, this->property->GetSpecularPower(component))
                                        : 0.0;
  return rgb *
    (this->property->GetAmbient(component) + this->property->GetDiffuse(component) * facing) +
    highlight;
}

OpticalProperties ReferenceMixture::OfDependent(glm::dvec3 positionGrid) const
{
  const int last = int(this->components.size()) - 1;
  const double extinction = this->ExtinctionOf(last, this->SampleAt(last, positionGrid));
  if (last == 1)
  {
    const double value = this->SampleAt(0, positionGrid).value;
    return { this->components[0].function.Color(value), extinction };
  }
  glm::dvec3 rgb;
  for (int channel = 0; channel < 3; ++channel)
  {
    rgb[channel] = this->SampleAt(channel, positionGrid).value / this->largestColor;
  }
  return { glm::clamp(rgb, 0.0, 1.0), extinction };
}

OpticalProperties ReferenceMixture::At(glm::dvec3 positionGrid, const Ray& rayGrid) const
{
  if (!this->property->GetIndependentComponents())
  {
    return this->OfDependent(positionGrid);
  }
  glm::dvec3 emission(0.0);
  double extinction = 0.0;
  for (int i = 0; i < int(this->components.size()); ++i)
  {
    const Sample sample = this->SampleAt(i, positionGrid);
    const double absorbed = this->components.size() > 1
      ? this->property->GetComponentWeight(i) * this->ExtinctionOf(i, sample)
      : this->ExtinctionOf(i, sample);
    const glm::dvec3 rgb = this->components[std::size_t(i)].function.Color(sample.value);
    emission +=
      absorbed > 0.0 ? absorbed * this->Lit(i, rgb, sample.gradient, rayGrid) : glm::dvec3(0.0);
    extinction += absorbed;
  }
  return { extinction > 0.0 ? emission / extinction : emission, extinction };
}
