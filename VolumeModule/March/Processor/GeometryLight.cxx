#include "March/Processor/GeometryLight.h"

#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// The diffuse and the specular part of a lamp that a surface sends to the eye.
struct Sent
{
  double diffuse;
  double specular;
};

Sent SentBy(const GeometryReceiver& receiver, glm::dvec3 toLight, double power)
{
  const double facing = glm::dot(receiver.normalWorld, toLight);
  if (!(facing > 0.0))
  {
    return { 0.0, 0.0 };
  }
  const glm::dvec3 mirrored = 2.0 * facing * receiver.normalWorld - toLight;
  return { facing,
    std::pow(std::max(glm::dot(mirrored, receiver.toEyeWorld), 0.0), std::max(power, 0.0)) };
}

// The part of a lamp's strength that is left at a distance, and inside its cone.
double StrengthOf(const glm::vec4* lamp, glm::dvec3 toLight, double distanceMm)
{
  const glm::dvec3 attenuation(lamp[3]);
  const double strength =
    1.0 / (attenuation.x + distanceMm * (attenuation.y + distanceMm * attenuation.z));
  const double alongAxis = -glm::dot(toLight, glm::dvec3(lamp[4]));
  return alongAxis < double(lamp[1].w)
    ? 0.0
    : strength * std::pow(std::max(alongAxis, 0.0), double(lamp[2].w));
}

}

GeometryLight::GeometryLight(const Frame& frame)
  : frame(frame)
  , lights(frame.lights.lamps)
  , head(frame.lights.head)
  , towardsHeadWorld(
      -glm::make_vec3(frame.view.renderer->GetActiveCamera()->GetDirectionOfProjection()))
{
}

glm::dvec3 GeometryLight::Ratio(glm::dvec3 left, glm::dvec3 whole)
{
  const auto part = [](double a, double b) { return b > 0.0 ? std::clamp(a / b, 0.0, 1.0) : 1.0; };
  return { part(left.x, whole.x), part(left.y, whole.y), part(left.z, whole.z) };
}

GeometryLight::Look GeometryLight::LookOf(std::size_t surface) const
{
  const CastingSurface& drawn = this->frame.casters.surfaces[surface];
  vtkProperty* const property = drawn.property;
  if (!property->GetLighting() || property->GetInterpolation() == VTK_PBR)
  {
    return { glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(0.0), 1.0 };
  }
  const auto colorOf = [&](const double* color)
  { return drawn.hasColors ? glm::dvec3(1.0) : glm::dvec3(glm::make_vec3(color)); };
  return { property->GetAmbient() * colorOf(property->GetAmbientColor()),
    property->GetDiffuse() * colorOf(property->GetDiffuseColor()),
    property->GetSpecular() * glm::make_vec3(property->GetSpecularColor()),
    property->GetSpecularPower() };
}

glm::dvec3 GeometryLight::HeadLightOn(const GeometryReceiver& receiver, const Look& look) const
{
  const Sent sent = SentBy(receiver, this->towardsHeadWorld, look.power);
  return (sent.diffuse * look.diffuse + sent.specular * look.specular) * this->head.diffuse;
}

glm::dvec3 GeometryLight::LampOn(int lamp, const GeometryReceiver& receiver, const Look& look) const
{
  const glm::vec4* const texels = &this->lights.texels[std::size_t(lamp) * LightTexels::PerLight];
  const bool isDistant = lamp < this->lights.distantCount;
  const glm::dvec3 way =
    isDistant ? glm::dvec3(texels[0]) : glm::dvec3(texels[0]) - receiver.placeWorld;
  const double distanceMm = glm::length(way);
  if (!(distanceMm > 0.0))
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3 toLight = way / distanceMm;
  const double strength = isDistant ? 1.0 : StrengthOf(texels, toLight, distanceMm);
  const Sent sent = SentBy(receiver, toLight, look.power);
  return strength * (sent.diffuse * look.diffuse + sent.specular * look.specular) *
    glm::dvec3(texels[1]);
}

}
