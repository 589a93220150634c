#include "Scene/ReferenceLighting.h"

#include "Core/Geometry/LightCone.h"
#include "Core/Reference/PathTracer.h"
#include "Scene/WorldVector.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

PlacedLight Placed(const SceneLight& light, const glm::dmat3& worldFromView)
{
  const glm::dvec3 rgb = light.intensity * VectorOf(light.rgb);
  switch (light.kind)
  {
    case LightKind::Head:
      return { light.kind, rgb, {}, 0.0 };
    case LightKind::Camera:
      return { light.kind, rgb, worldFromView * glm::normalize(VectorOf(light.direction)),
        light.softnessDegrees };
    case LightKind::Directional:
      return { light.kind, rgb, glm::normalize(VectorOf(light.direction)), light.softnessDegrees };
    default:
      return { light.kind, rgb, VectorOf(light.positionMm), light.softnessDegrees };
  }
}

glm::dvec3 TowardsLight(const PlacedLight& light, const LitPoint& point)
{
  switch (light.kind)
  {
    case LightKind::Head:
      return point.toEye;
    case LightKind::Positional:
      return glm::normalize(light.place - point.positionMm);
    default:
      return light.place;
  }
}

double DistanceMm(const PlacedLight& light, const LitPoint& point)
{
  return light.kind == LightKind::Positional ? glm::length(light.place - point.positionMm)
                                             : std::numeric_limits<double>::infinity();
}

// The unit vector half way between two others; 0 if they are opposite.
glm::dvec3 HalfWay(glm::dvec3 one, glm::dvec3 other)
{
  const glm::dvec3 sum = one + other;
  const double length = glm::length(sum);
  return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

// The mean over the directions that a light comes from.
double Arriving(
  const PlacedLight& light, glm::dvec3 towards, double farMm, const LightReaching& reaching)
{
  if (light.softnessDegrees == 0.0)
  {
    return reaching(towards, farMm);
  }
  double sum = 0.0;
  for (const auto& [direction, weight] :
    DirectionsInCone(towards, glm::radians(light.softnessDegrees)))
  {
    sum += weight * reaching(direction, farMm);
  }
  return sum;
}

/// Columns are the image's axes to the right, upwards and towards the eye.
glm::dmat3 WorldFromView(vtkCamera* camera)
{
  // The matrix of VTK has its rows one after the other: reading them as columns inverts a rotation.
  return glm::dmat3(glm::make_mat4(camera->GetViewTransformMatrix()->GetData()));
}

}

bool ReferenceLighting::IsPlainHeadLight() const
{
  return this->scatteredPart == 0.0 && this->dampingGradient == 0.0 && this->lights.size() == 1 &&
    this->lights[0].kind == LightKind::Head && this->lights[0].rgb == glm::dvec3(1.0);
}

glm::dvec3 ReferenceLighting::Lit(const LitPoint& point, const LightReaching& reaching) const
{
  const auto facing = [&](glm::dvec3 direction)
  {
    const double cosine = glm::dot(point.normal, direction);
    return std::clamp(this->lightsBacks ? std::abs(cosine) : cosine, 0.0, 1.0);
  };
  const double undamped =
    this->dampingGradient > 0.0 ? std::min(point.gradientPerMm / this->dampingGradient, 1.0) : 1.0;
  glm::dvec3 diffuse(0.0);
  glm::dvec3 specular(0.0);
  for (const PlacedLight& light : this->lights)
  {
    const glm::dvec3 towards = TowardsLight(light, point);
    const double cosine = facing(towards);
    if (cosine == 0.0 && this->scatteredPart == 0.0)
    {
      continue;
    }
    const bool isDimmed = reaching && light.kind != LightKind::Head;
    const double arriving =
      isDimmed ? Arriving(light, towards, DistanceMm(light, point), reaching) : 1.0;
    const double onSurfaces =
      (1.0 - this->scatteredPart) * undamped * glm::mix(1.0, arriving, this->surfacesInShadow);
    const double scattered = this->scatteredPart * arriving *
      HenyeyGreenstein(-glm::dot(towards, point.toEye), this->anisotropy);
    const double shining = cosine > 0.0 ? facing(HalfWay(towards, point.toEye)) : 0.0;
    diffuse += (onSurfaces * cosine + scattered) * light.rgb;
    specular += onSurfaces * std::pow(shining, this->shading.specularPower) * light.rgb;
  }
  return point.rgb * (this->shading.ambient + this->shading.diffuse * diffuse) +
    this->shading.specular * specular;
}

ReferenceLighting ReferenceLightingOf(
  const Scene& scene, const Look& look, vtkCamera* camera, const VolumeGeometry& geometry)
{
  const std::vector<SceneLight>& lights = scene.lights;
  const bool hasHeadLightsOnly = std::all_of(lights.begin(), lights.end(),
    [](const SceneLight& light) { return light.kind == LightKind::Head; });
  const bool isComposite = look.blend == Blend::Composite;
  const Scattering scattering = isComposite ? scene.scattering : Scattering();
  const bool dimsScattered = scattering.blending > 0.0 && scattering.reach > 0.0;
  ReferenceLighting lighting{ look.shading, look.dampingGradient, {}, hasHeadLightsOnly,
    isComposite && (scene.shadows > 0.0 || dimsScattered), scene.shadows,
    ShadowReachMm(scene.shadows > 0.0 ? 1.0 : scattering.reach, geometry),
    std::min(scattering.blending, 1.0), scattering.anisotropy };
  const glm::dmat3 worldFromView = WorldFromView(camera);
  for (const SceneLight& light : lights.empty() ? std::vector<SceneLight>(1) : lights)
  {
    lighting.lights.push_back(Placed(light, worldFromView));
  }
  return lighting;
}

}
