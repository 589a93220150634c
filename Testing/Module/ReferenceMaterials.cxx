#include "Module/ReferenceMaterials.h"

#include "Core/Geometry/LightCone.h"
#include "Core/Reference/LightTransmittance.h"
#include "Core/Reference/PathTracer.h"
#include "Core/Reference/SkyVisibility.h"
#include "Frame/PropertyTransferFunction.h"
#include "Stages/CutRays.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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

bool ShinesOn(vtkLight* light, glm::dvec3 toLight, glm::dvec3 axis)
{
  return !light->GetPositional() || light->GetConeAngle() >= 90.0 ||
    glm::dot(-toLight, axis) >= std::cos(glm::radians(light->GetConeAngle()));
}

struct LitPoint
{
  glm::dvec3 rgb; ///< colour by the transfer function
  glm::dvec3 positionGrid;
  glm::dvec3 positionWorld;
  glm::dvec3 normal;
  glm::dvec3 toEye;
};

// The mean over the directions that a light comes from.
double MeanReaching(vtkLight* light, const LitPoint& point, glm::dvec3 toLight, double farMm,
  const LightReaching& reaching)
{
  vtkInformationDoubleKey* const softness = vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS();
  if (!light->GetInformation()->Has(softness))
  {
    return reaching(point.positionGrid, toLight, farMm);
  }
  double mean = 0.0;
  const double radians = glm::radians(light->GetInformation()->Get(softness));
  for (const auto& [direction, weight] : DirectionsInCone(toLight, radians))
  {
    mean += weight * reaching(point.positionGrid, direction, farMm);
  }
  return mean;
}

// Light that a light casts to the eye, two-sided and without attenuation, and the part of it that
// matter scatters.
glm::dvec3 LightFrom(
  vtkLight* light, MapperScene& scene, const LitPoint& point, const LightReaching& reaching)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  const glm::dvec3 position = glm::make_vec3(light->GetTransformedPosition());
  const glm::dvec3 focus = glm::make_vec3(light->GetTransformedFocalPoint());
  const glm::dvec3 axis = glm::normalize(focus - position);
  const bool isNear = light->GetPositional() != 0;
  const glm::dvec3 toLight = isNear ? -glm::normalize(point.positionWorld - position) : -axis;
  if (!ShinesOn(light, toLight, axis))
  {
    return glm::dvec3(0.0);
  }
  const double farMm =
    isNear ? glm::length(point.positionWorld - position) : std::numeric_limits<double>::infinity();
  const double part = reaching ? MeanReaching(light, point, toLight, farMm, reaching) : 1.0;
  const double shining = std::abs(glm::dot(point.normal, glm::normalize(toLight + point.toEye)));
  const double onSurfaces = 1.0 - scene.mapper->GetShadowStrength() * (1.0 - part);
  const double scattered = std::min(scene.mapper->GetVolumetricScatteringBlending(), 1.0);
  const double phase =
    HenyeyGreenstein(-glm::dot(toLight, point.toEye), scene.mapper->GetScatteringAnisotropy());
  const double diffuse =
    onSurfaces * (1.0 - scattered) * std::abs(glm::dot(point.normal, toLight)) +
    part * scattered * phase;
  return property->GetDiffuse() * diffuse * point.rgb * glm::make_vec3(light->GetDiffuseColor()) +
    onSurfaces * (1.0 - scattered) * property->GetSpecular() *
    std::pow(shining, property->GetSpecularPower()) * glm::make_vec3(light->GetSpecularColor());
}

}

MapperScene::Material MaterialInLights(MapperScene& scene)
{
  return MaterialInShadows(scene, {});
}

MapperScene::Material MaterialInShadows(MapperScene& scene, const LightReaching& reaching)
{
  const auto samples = std::make_shared<SceneSamples>(scene);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return [&scene, samples, function, reaching](glm::dvec3 position, const Ray& ray)
  {
    const double value = samples->Value(position);
    const double extinction = function.Extinction(value);
    const LitPoint point{ function.Color(value), position, samples->PositionWorld(position),
      samples->NormalWorld(samples->Gradient(position)), samples->ToEyeWorld(ray) };
    glm::dvec3 sum(0.0);
    vtkCollectionSimpleIterator iterator;
    scene.renderer->GetLights()->InitTraversal(iterator);
    while (vtkLight* light = scene.renderer->GetLights()->GetNextLight(iterator))
    {
      // A point that absorbs nothing emits nothing, and needs no shadow.
      sum += extinction > 0.0 ? LightFrom(light, scene, point, reaching) : glm::dvec3(0.0);
    }
    return OpticalProperties{ sum, extinction };
  };
}

namespace
{

// The light that the volume of a scene lets through, within its cuts.
std::shared_ptr<const LightTransmittance> TransmittanceOf(
  MapperScene& scene, const std::shared_ptr<const SceneSamples>& samples, double tolerance)
{
  const VolumeGeometry& geometry = samples->Geometry();
  ReferenceScene opacities{ [samples](glm::ivec3 cell)
    { return CornersOfCell(samples->Grid(), cell); },
    geometry.boxGrid, TransferFunctionOf(scene.volume->GetProperty()) };
  opacities.uncutParts = CutRays(scene.mapper, geometry.worldFromGrid, geometry.dataFromGrid);
  return std::make_shared<const LightTransmittance>(
    opacities, glm::inverse(geometry.WorldFromGridDirection()), tolerance);
}

}

LightReaching LightThroughVolume(MapperScene& scene, double tolerance)
{
  const auto transmittance =
    TransmittanceOf(scene, std::make_shared<const SceneSamples>(scene), tolerance);
  return [transmittance](glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm)
  { return transmittance->Towards(positionGrid, towardsWorld, farMm); };
}

MapperScene::Material MaterialInOwnShadows(MapperScene& scene, double tolerance)
{
  return MaterialInShadows(scene, LightThroughVolume(scene, tolerance));
}

MapperScene::Material OccludedMaterial(MapperScene& scene, double tolerance)
{
  const auto samples = std::make_shared<const SceneSamples>(scene);
  const auto transmittance = TransmittanceOf(scene, samples, tolerance);
  const double reachMm =
    OcclusionReachMm(scene.mapper->GetAmbientOcclusionReach(), samples->Geometry());
  const TransferFunction look = TransferFunctionOf(scene.volume->GetProperty());
  const MapperScene::Material lit = MaterialInLights(scene);
  return [=, &scene](glm::dvec3 position, const Ray& ray)
  {
    OpticalProperties properties = lit(position, ray);
    if (properties.extinction > 0.0)
    {
      const double value = samples->Value(position);
      const glm::dvec3 gradient = samples->Gradient(position);
      const double perVoxel = glm::length(gradient);
      const bool isThinnerUp =
        look.Extinction(value + perVoxel) < look.Extinction(value - perVoxel);
      properties.rgb *= KeptLight(
        SkyVisibility(*transmittance, reachMm).At(OutsideOf(position, gradient, isThinnerUp)),
        scene.mapper->GetAmbientOcclusion());
    }
    return properties;
  };
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
