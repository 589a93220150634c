#include "Scene/Reference/ReferenceMaterial.h"

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Reference/LightTransmittance.h"
#include "Core/Reference/SplineGrid.h"
#include "Scene/Looks/LookRegions.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace varimarch
{

namespace
{

// The quadrature needs finite numbers. A hundredth of a micrometre of such a material is opaque.
constexpr double MostExtinction = 1e6;

glm::dvec3 NearestVoxel(glm::dvec3 position, glm::ivec3 dimensions)
{
  return glm::clamp(glm::floor(position + 0.5), glm::dvec3(0.0), glm::dvec3(dimensions - 1));
}

struct VolumeSamples
{
  std::function<double(glm::dvec3)> value;
  std::function<glm::dvec3(glm::dvec3)> gradient;
};

VolumeSamples CubicSamples(const ReferenceRequest& request)
{
  std::vector<double> voxels(std::size_t(request.scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = request.scalars->GetComponent(vtkIdType(i), 0);
  }
  if (!std::all_of(voxels.begin(), voxels.end(), [](double voxel) { return std::isfinite(voxel); }))
  {
    throw std::invalid_argument(
      "Reference image: cubic interpolation expected finite voxels, found others");
  }
  const auto spline =
    std::make_shared<const SplineGrid>(std::move(voxels), request.geometry.dimensions);
  return { [spline](glm::dvec3 position) { return spline->Value(position); },
    [spline](glm::dvec3 position) { return spline->Gradient(position); } };
}

template <class Scalar>
VolumeSamples SamplesOf(const ReferenceRequest& request, const Scalar* voxels)
{
  const ScalarGrid<Scalar> grid(voxels, request.geometry.dimensions);
  if (request.interpolation == Interpolation::Linear)
  {
    return { [grid](glm::dvec3 position) { return grid.Value(position); },
      [grid](glm::dvec3 position) { return grid.Gradient(position); } };
  }
  const auto nearest = [size = request.geometry.dimensions](glm::dvec3 position)
  { return NearestVoxel(position, size); };
  return { [grid, nearest](glm::dvec3 position) { return grid.Value(nearest(position)); },
    [grid, nearest](glm::dvec3 position) { return grid.Gradient(nearest(position)); } };
}

VolumeSamples SamplesOf(const ReferenceRequest& request)
{
  if (request.interpolation == Interpolation::Cubic)
  {
    return CubicSamples(request);
  }
  VolumeSamples samples;
  switch (request.scalars->GetDataType())
  {
    vtkTemplateMacro(
      samples = SamplesOf(request, static_cast<const VTK_TT*>(request.scalars->GetVoidPointer(0))));
  }
  return samples;
}

glm::dvec3 UnitOrZero(glm::dvec3 vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0); // also for NaN
}

}

ReferenceMaterial::ReferenceMaterial(
  const ReferenceRequest& request, std::shared_ptr<const LightTransmittance> transmittance)
  : request(request)
  , transmittance(std::move(transmittance))
  , gradientOpacity({}, request.gradientOpacities, 1.0)
{
  VolumeSamples samples = SamplesOf(request);
  this->value = std::move(samples.value);
  this->gradient = std::move(samples.gradient);
}

PieceLight ReferenceMaterial::LightAlong(const CellPart& part, const Ray& rayGrid) const
{
  return { [this, part, rayGrid](glm::dvec3 rgb, double u)
    {
      const double t = part.t.enter + u * (part.t.exit - part.t.enter);
      const glm::dvec3 position = rayGrid.origin + t * rayGrid.direction;
      return this->Emitted(rgb, this->gradient(position), position, rayGrid);
    } };
}

OpticalProperties ReferenceMaterial::At(glm::dvec3 positionGrid, const Ray& rayGrid) const
{
  const double value = this->value(positionGrid);
  if (!std::isfinite(value))
  {
    return { glm::dvec3(0.0), 0.0 };
  }
  const glm::dvec3 gradient = this->gradient(positionGrid);
  OpticalProperties properties = this->Unlit(value, this->GradientPerMm(gradient));
  properties.extinction = std::min(properties.extinction, MostExtinction);
  if (properties.extinction > 0.0)
  {
    properties.rgb = this->Emitted(properties.rgb, gradient, positionGrid, rayGrid);
  }
  return properties;
}

// The magnitude that VTK's functions of gradients depend on is in the image's own axes, and ends at
// a quarter of the range per mean spacing.
double ReferenceMaterial::GradientPerMm(glm::dvec3 gradient) const
{
  const double perMm = 2.0 * glm::length(this->request.geometry.gradientFactors * gradient) /
    this->request.meanSpacingMm;
  return std::isfinite(perMm) ? perMm : 0.0;
}

OpticalProperties ReferenceMaterial::Unlit(double value, double gradientPerMm) const
{
  const TransferFunction& function = this->request.transferFunction;
  const double limited = std::min(gradientPerMm, this->request.largestGradientPerMm);
  if (!this->request.regions.empty())
  {
    const glm::dvec4 color = ColorInRegions(this->request.regions, value, limited);
    return { glm::dvec3(color), -std::log1p(-color.a) / function.OpacityUnitDistanceMm() };
  }
  if (!this->request.gradientOpacities.empty())
  {
    const double opacity = this->gradientOpacity.Opacity(limited) * function.Opacity(value);
    return { function.Color(value), -std::log1p(-opacity) / function.OpacityUnitDistanceMm() };
  }
  return { function.Color(value), function.Extinction(value) };
}

glm::dvec3 ReferenceMaterial::Emitted(
  glm::dvec3 rgb, glm::dvec3 gradient, glm::dvec3 positionGrid, const Ray& rayGrid) const
{
  const glm::dvec3 lit =
    this->request.lighting ? this->Lit(rgb, gradient, positionGrid, rayGrid) : rgb;
  return this->request.occlusion.strength > 0.0 ? this->KeptAt(gradient, positionGrid) * lit : lit;
}

glm::dvec3 ReferenceMaterial::MiddleOf(glm::dvec3 positionGrid) const
{
  return this->request.interpolation == Interpolation::Nearest
    ? NearestVoxel(positionGrid, this->request.geometry.dimensions)
    : positionGrid;
}

// The part of its light that a place keeps under ambient occlusion. A box has that of its middle.
double ReferenceMaterial::KeptAt(glm::dvec3 gradient, glm::dvec3 positionGrid) const
{
  const double value = this->value(positionGrid);
  const double perMm = this->GradientPerMm(gradient);
  const bool isThinnerUp = IsThinnerUp(
    value, gradient, [&](double other) { return this->Unlit(other, perMm).extinction; });
  const SkyVisibility sky(*this->transmittance, this->request.occlusion.reachMm);
  return KeptLight(sky.At(OutsideOf(this->MiddleOf(positionGrid), gradient, isThinnerUp)),
    this->request.occlusion.strength);
}

glm::dvec3 ReferenceMaterial::Lit(
  glm::dvec3 rgb, glm::dvec3 gradient, glm::dvec3 positionGrid, const Ray& rayGrid) const
{
  const VolumeGeometry& geometry = this->request.geometry;
  const LitPoint point{ rgb, glm::dvec3(geometry.worldFromGrid * glm::dvec4(positionGrid, 1.0)),
    -UnitOrZero(geometry.WorldFromGridNormal() * gradient),
    -glm::normalize(geometry.WorldFromGridDirection() * rayGrid.direction),
    this->GradientPerMm(gradient) };
  if (!this->request.lighting->castsShadows)
  {
    return this->request.lighting->Lit(point);
  }
  return this->request.lighting->Lit(point,
    [&](glm::dvec3 towards, double farMm)
    {
      return this->transmittance->Towards(
        positionGrid, towards, std::min(farMm, this->request.lighting->reachMm));
    });
}

}
