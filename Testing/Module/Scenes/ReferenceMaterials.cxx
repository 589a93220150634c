#include "Module/Scenes/ReferenceMaterials.h"

#include "Frame/PropertyTransferFunction.h"

#include <vtkDataArray.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace varimarch;

SceneSamples::SceneSamples(MapperScene& scene)
  : geometry(VolumeGeometryOf(scene.image, scene.volume))
{
  vtkDataArray* const scalars = scene.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    this->voxels.push_back(scalars->GetComponent(i, 0));
  }
}

double SceneSamples::Magnitude(glm::dvec3 gradient) const
{
  // The factors are those of differences between the neighbours on both sides.
  return 2.0 * glm::length(this->geometry.gradientFactors * gradient);
}

double SceneSamples::Facing(glm::dvec3 gradient, const Ray& rayGrid) const
{
  return std::abs(glm::dot(this->NormalWorld(gradient), this->ToEyeWorld(rayGrid)));
}

glm::dvec3 SceneSamples::NormalWorld(glm::dvec3 gradient) const
{
  const glm::dvec3 normal = this->geometry.WorldFromGridNormal() * gradient;
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

glm::dvec3 SceneSamples::ToEyeWorld(const Ray& rayGrid) const
{
  return -glm::normalize(this->geometry.WorldFromGridDirection() * rayGrid.direction);
}

glm::dvec3 SceneSamples::PositionWorld(glm::dvec3 positionGrid) const
{
  return glm::dvec3(this->geometry.worldFromGrid * glm::dvec4(positionGrid, 1.0));
}

namespace
{

// Colour in a head light, whose diffuse and specular parts are multiplied by a factor.
glm::dvec3 InHeadLight(
  vtkVolumeProperty* property, glm::dvec3 rgb, double facing, double factor = 1.0)
{
  return rgb * (property->GetAmbient() + factor * property->GetDiffuse() * facing) +
    factor * property->GetSpecular() * std::pow(facing, property->GetSpecularPower());
}

}

MapperScene::Material DampedMaterial(MapperScene& scene)
{
  const auto samples = std::make_shared<SceneSamples>(scene);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return [&scene, samples, function](glm::dvec3 position, const Ray& ray)
  {
    const double value = samples->Value(position);
    const glm::dvec3 gradient = samples->Gradient(position);
    const double part =
      std::min(samples->Magnitude(gradient) / scene.mapper->GetDampingGradient(), 1.0);
    return OpticalProperties{ InHeadLight(scene.volume->GetProperty(), function.Color(value),
                                samples->Facing(gradient, ray), part),
      function.Extinction(value) };
  };
}

namespace
{

// An entry of a table between its points; both places are fractions of their ranges.
glm::dvec4 EntryAt(vtkImageData* table, double first, double second)
{
  const int* const size = table->GetDimensions();
  const double x = std::clamp(first, 0.0, 1.0) * (size[0] - 1);
  const double y = std::clamp(second, 0.0, 1.0) * (size[1] - 1);
  const int column = std::min(int(x), std::max(size[0] - 2, 0));
  const int row = std::min(int(y), std::max(size[1] - 2, 0));
  glm::dvec4 entry;
  for (int channel = 0; channel < 4; ++channel)
  {
    const auto at = [&](int right, int up)
    {
      return table->GetScalarComponentAsDouble(
        std::min(column + right, size[0] - 1), std::min(row + up, size[1] - 1), 0, channel);
    };
    entry[channel] = glm::mix(
      glm::mix(at(0, 0), at(1, 0), x - column), glm::mix(at(0, 1), at(1, 1), x - column), y - row);
  }
  return entry;
}

}

MapperScene::Material MaterialOfTwoValues(MapperScene& scene)
{
  const auto samples = std::make_shared<SceneSamples>(scene);
  const glm::dvec2 range(scene.image->GetScalarRange()[0], scene.image->GetScalarRange()[1]);
  return [&scene, samples, range](glm::dvec3 position, const Ray& ray)
  {
    vtkVolumeProperty* const property = scene.volume->GetProperty();
    const glm::dvec3 gradient = samples->Gradient(position);
    const double first = (samples->Value(position) - range[0]) / (range[1] - range[0]);
    const double second = samples->Magnitude(gradient) / (0.25 * (range[1] - range[0]));
    const glm::dvec4 entry = EntryAt(property->GetTransferFunction2D(), first, second);
    const glm::dvec3 rgb(entry);
    return OpticalProperties{
      property->GetShade() ? InHeadLight(property, rgb, samples->Facing(gradient, ray)) : rgb,
      -std::log1p(-entry.a)
    };
  };
}

MapperScene::Material MaskedMaterial(MapperScene& scene)
{
  const auto samples = std::make_shared<SceneSamples>(scene);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return [&scene, samples, function](glm::dvec3 position, const Ray&)
  {
    vtkImageData* const mask = scene.mapper->GetMaskInput();
    const glm::ivec3 last = glm::make_vec3(mask->GetDimensions()) - 1;
    const glm::ivec3 nearest =
      glm::clamp(glm::ivec3(glm::floor(position + 0.5)), glm::ivec3(0), last);
    const bool isSeen = mask->GetScalarComponentAsDouble(nearest.x, nearest.y, nearest.z, 0) > 0.0;
    const double value = samples->Value(position);
    return OpticalProperties{ function.Color(value), isSeen ? function.Extinction(value) : 0.0 };
  };
}

namespace
{

bool IsClipped(vtkPlaneCollection* planes, glm::dvec3 positionWorld)
{
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    if (planes->GetItem(i)->EvaluateFunction(glm::value_ptr(positionWorld)) < 0.0)
    {
      return true;
    }
  }
  return false;
}

}

MapperScene::Material MaterialWithClippedIntensity(MapperScene& scene)
{
  const auto samples = std::make_shared<SceneSamples>(scene);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return [&scene, samples, function](glm::dvec3 position, const Ray& ray)
  {
    vtkVolumeProperty* const property = scene.volume->GetProperty();
    const auto valueBeside = [&](glm::dvec3 place)
    {
      return IsClipped(scene.mapper->GetClippingPlanes(), samples->PositionWorld(place))
        ? property->GetClippedVoxelIntensity()
        : samples->Value(place);
    };
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 offset(0.0);
      offset[axis] = 1.0;
      gradient[axis] = 0.5 * (valueBeside(position + offset) - valueBeside(position - offset));
    }
    const double value = samples->Value(position);
    return OpticalProperties{ InHeadLight(
                                property, function.Color(value), samples->Facing(gradient, ray)),
      function.Extinction(value) };
  };
}
