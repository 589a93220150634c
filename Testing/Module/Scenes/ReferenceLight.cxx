// The light of the materials of a reference.

#include "Module/Scenes/ReferenceMaterials.h"

#include "Core/Geometry/LightCone.h"
#include "Core/Reference/LightTransmittance.h"
#include "Core/Reference/PathTracer.h"
#include "Frame/PropertyTransferFunction.h"
#include "Stages/CutRays.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace varimarch;

namespace
{

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

UnlitLook InterpolatedLook(MapperScene& scene)
{
  const auto samples = std::make_shared<const SceneSamples>(scene);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return { [samples](glm::dvec3 position) { return samples->Value(position); },
    [samples](glm::dvec3 position) { return samples->Gradient(position); },
    [function](glm::dvec3, double value) {
      return OpticalProperties{ function.Color(value), function.Extinction(value) };
    },
    [](glm::dvec3 position) { return position; } };
}

UnlitLook LookOfBoxes(MapperScene& scene)
{
  const UnlitLook look = InterpolatedLook(scene);
  const glm::dvec3 last = glm::make_vec3(scene.image->GetDimensions()) - 1;
  const auto voxelOf = [last](glm::dvec3 position)
  { return glm::clamp(glm::floor(position + 0.5), glm::dvec3(0.0), last); };
  return { [=](glm::dvec3 position) { return look.value(voxelOf(position)); },
    [=](glm::dvec3 position) { return look.gradient(voxelOf(position)); }, look.properties,
    voxelOf };
}

namespace
{

// A look in the renderer's lights.
MapperScene::Material LitMaterial(
  MapperScene& scene, const UnlitLook& look, const LightReaching& reaching)
{
  const auto samples = std::make_shared<const SceneSamples>(scene);
  return [&scene, samples, look, reaching](glm::dvec3 position, const Ray& ray)
  {
    const OpticalProperties unlit = look.At(position);
    const LitPoint point{ unlit.rgb, position, samples->PositionWorld(position),
      samples->NormalWorld(look.gradient(position)), samples->ToEyeWorld(ray) };
    glm::dvec3 sum(0.0);
    vtkCollectionSimpleIterator iterator;
    scene.renderer->GetLights()->InitTraversal(iterator);
    while (vtkLight* light = scene.renderer->GetLights()->GetNextLight(iterator))
    {
      // A point that absorbs nothing emits nothing, and needs no shadow.
      sum += unlit.extinction > 0.0 ? LightFrom(light, scene, point, reaching) : glm::dvec3(0.0);
    }
    return OpticalProperties{ sum, unlit.extinction };
  };
}

using Transmittance = std::shared_ptr<const LightTransmittance>;

Transmittance TransmittanceOf(
  MapperScene& scene, const VolumeGeometry& geometry, ReferenceScene opacities, double tolerance)
{
  opacities.boxGrid = geometry.boxGrid;
  opacities.uncutParts = CutRays(scene.mapper, geometry.worldFromGrid, geometry.dataFromGrid);
  return std::make_shared<const LightTransmittance>(
    opacities, glm::inverse(geometry.WorldFromGridDirection()), tolerance);
}

// The light that the volume of a scene lets through, within its cuts.
Transmittance TransmittanceOf(
  MapperScene& scene, const std::shared_ptr<const SceneSamples>& samples, double tolerance)
{
  return TransmittanceOf(scene, samples->Geometry(),
    ReferenceScene{ [samples](glm::ivec3 cell) { return CornersOfCell(samples->Grid(), cell); }, {},
      TransferFunctionOf(scene.volume->GetProperty()) },
    tolerance);
}

// The light that a look lets through, within the cuts of a scene.
Transmittance TransmittanceOf(MapperScene& scene, const UnlitLook& look, double tolerance)
{
  ReferenceScene opacities{ {}, {}, TransferFunctionOf(scene.volume->GetProperty()) };
  opacities.material = [look](glm::dvec3 position, const Ray&) { return look.At(position); };
  return TransmittanceOf(scene, SceneSamples(scene).Geometry(), opacities, tolerance);
}

LightReaching ReachingThrough(const Transmittance& transmittance)
{
  return [transmittance](glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm)
  { return transmittance->Towards(positionGrid, towardsWorld, farMm); };
}

// A material with the mapper's ambient occlusion.
MapperScene::Material Occluded(MapperScene& scene, const UnlitLook& look,
  const Transmittance& transmittance, const MapperScene::Material& lit)
{
  const double reachMm =
    OcclusionReachMm(scene.mapper->GetAmbientOcclusionReach(), SceneSamples(scene).Geometry());
  return [=, &scene](glm::dvec3 position, const Ray& ray)
  {
    OpticalProperties properties = lit(position, ray);
    if (properties.extinction > 0.0)
    {
      const double value = look.value(position);
      const glm::dvec3 gradient = look.gradient(position);
      const bool isThinnerUp = IsThinnerUp(
        value, gradient, [&](double other) { return look.properties(position, other).extinction; });
      const glm::dvec3 outside = OutsideOf(look.surface(position), gradient, isThinnerUp);
      properties.rgb *= KeptLight(
        SkyVisibility(*transmittance, reachMm).At(outside), scene.mapper->GetAmbientOcclusion());
    }
    return properties;
  };
}

}

MapperScene::Material DimmedMaterial(MapperScene& scene, const UnlitLook& look, double tolerance)
{
  const Transmittance transmittance = TransmittanceOf(scene, look, tolerance);
  const MapperScene::Material lit = LitMaterial(
    scene, look, scene.mapper->GetShadows() ? ReachingThrough(transmittance) : LightReaching());
  const MapperScene::Material dimmed =
    scene.mapper->GetAmbientOcclusion() > 0.0 ? Occluded(scene, look, transmittance, lit) : lit;
  // MapperScene::TruthOf counts boxes from their lower faces.
  const bool areBoxes =
    scene.volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  const double before = areBoxes ? 0.5 : 0.0;
  return [dimmed, before](glm::dvec3 position, const Ray& ray)
  { return dimmed(position - before, ray); };
}

MapperScene::Material MaterialInLights(MapperScene& scene)
{
  return MaterialInShadows(scene, {});
}

MapperScene::Material MaterialInShadows(MapperScene& scene, const LightReaching& reaching)
{
  return LitMaterial(scene, InterpolatedLook(scene), reaching);
}

LightReaching LightThroughVolume(MapperScene& scene, double tolerance)
{
  return ReachingThrough(
    TransmittanceOf(scene, std::make_shared<const SceneSamples>(scene), tolerance));
}

MapperScene::Material MaterialInOwnShadows(MapperScene& scene, double tolerance)
{
  return MaterialInShadows(scene, LightThroughVolume(scene, tolerance));
}

MapperScene::Material OccludedMaterial(MapperScene& scene, double tolerance)
{
  return Occluded(scene, InterpolatedLook(scene),
    TransmittanceOf(scene, std::make_shared<const SceneSamples>(scene), tolerance),
    MaterialInLights(scene));
}
