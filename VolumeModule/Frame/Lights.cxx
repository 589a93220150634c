#include "Frame/Lights.h"

#include "Frame/NumberCheck.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "Core/Geometry/LightCone.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace varimarch
{

namespace
{

// A cone this wide does not limit the light, as in OpenGL.
constexpr double WidestConeDegrees = 90.0;
constexpr double NoCone = -2.0; // less than any cosine

// The square of this distance and its products are floats.
constexpr double FarthestLampMm = 1e15;

/// The usable numbers of a light, and its unit vectors [world space].
struct Lamp
{
  bool isNear;
  glm::dvec3 position;
  glm::dvec3 shinesAlong; ///< 0 if it shines nowhere.
  double coneHeight;
  double coneCosine;
  double exponent;
  glm::dvec3 attenuation;
  glm::dvec3 diffuse; ///< The colours times the intensity.
  glm::dvec3 specular;
  glm::dvec3 ambient;
};

std::vector<vtkLight*> LightsThatAreOn(vtkRenderer* renderer)
{
  std::vector<vtkLight*> lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  while (vtkLight* light = all->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      lights.push_back(light);
    }
  }
  return lights;
}

bool IsPlainHeadLight(vtkLight* light)
{
  return light->LightTypeIsHeadlight() && !light->GetPositional();
}

bool IsFinite(const glm::dvec3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

double LargestNumberOf(const glm::dvec3& vector)
{
  const glm::dvec3 absolute = glm::abs(vector);
  return std::max({ absolute.x, absolute.y, absolute.z });
}

// The length of a vector whose square may overflow.
double LengthOf(const glm::dvec3& vector)
{
  const double largest = LargestNumberOf(vector);
  return largest > 0.0 ? largest * glm::length(vector / largest) : 0.0;
}

// The direction of a vector whose square may overflow; 0 if it has none.
glm::dvec3 DirectionOf(const glm::dvec3& vector)
{
  const double largest = LargestNumberOf(vector);
  return largest > 0.0 ? glm::normalize(vector / largest) : glm::dvec3(0.0);
}

double ConeHeightOf(vtkLight* light, NumberCheck& check)
{
  constexpr double MostDegrees = 90.0;
  vtkInformation* const information = light->GetInformation();
  vtkInformationDoubleKey* const key = vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS();
  const double degrees = information && information->Has(key) ? information->Get(key) : 0.0;
  return 1.0 -
    std::cos(
      glm::radians(check.Usable({ "the light's key LIGHT_SOFTNESS", 0.0, MostDegrees }, degrees)));
}

glm::dvec3 AttenuationOf(vtkLight* light, NumberCheck& check)
{
  const NumberSetting setting{ "vtkLight::SetAttenuationValues", 0.0 };
  const glm::dvec3 values = check.Usable(setting, light->GetAttenuationValues());
  const glm::dvec3 none(1.0, 0.0, 0.0);
  if (values == glm::dvec3(0.0))
  {
    check.Note("Cannot use the numbers " + TextOf(values) +
      " of vtkLight::SetAttenuationValues: expected one above 0, as the light is infinite without "
      "any. " +
      TextOf(none) + " is used instead; set other numbers.");
    return none;
  }
  // A lamp among matter would be infinitely bright at its place.
  constexpr double AtItsPlace = 1e-12;
  return { std::max(values.x, AtItsPlace), values.y, values.z };
}

// The colours of a light. Their products are floats.
void TakeColors(vtkLight* light, NumberCheck& check, Lamp& lamp)
{
  constexpr double Brightest = 1e6;
  const double intensity =
    check.Usable({ "vtkLight::SetIntensity", -Brightest, Brightest, 1.0 }, light->GetIntensity());
  const auto colorOf = [&](const char* setter, double usual, const double* color) {
    return intensity * check.Usable({ setter, -Brightest, Brightest, usual }, color);
  };
  lamp.diffuse = colorOf("vtkLight::SetDiffuseColor", 1.0, light->GetDiffuseColor());
  lamp.specular = colorOf("vtkLight::SetSpecularColor", 1.0, light->GetSpecularColor());
  lamp.ambient = colorOf("vtkLight::SetAmbientColor", 0.0, light->GetAmbientColor());
}

// A lamp without a place gives no light.
std::optional<Lamp> LampOf(vtkLight* light, NumberCheck& check)
{
  constexpr double UsualConeDegrees = 30.0;
  constexpr double MostExponent = 128.0;
  const glm::dvec3 position = glm::make_vec3(light->GetTransformedPosition());
  const glm::dvec3 focus = glm::make_vec3(light->GetTransformedFocalPoint());
  if (!IsFinite(position) || !IsFinite(focus))
  {
    check.Note("Cannot use a light that is at " + TextOf(position) + " and shines on " +
      TextOf(focus) +
      ": expected finite numbers of vtkLight::SetPosition, SetFocalPoint and its "
      "matrix. It is left out; set other numbers.");
    return std::nullopt;
  }
  const double coneDegrees =
    check.Usable({ "vtkLight::SetConeAngle", 0.0, 180.0, UsualConeDegrees }, light->GetConeAngle());
  const bool hasCone = coneDegrees < WidestConeDegrees;
  Lamp lamp = {};
  lamp.isNear = light->GetPositional() != 0;
  lamp.position = position;
  lamp.shinesAlong = DirectionOf(0.5 * focus - 0.5 * position);
  lamp.coneHeight = ConeHeightOf(light, check);
  lamp.coneCosine = hasCone ? std::cos(glm::radians(coneDegrees)) : NoCone;
  lamp.exponent = hasCone
    ? check.Usable({ "vtkLight::SetExponent", 0.0, MostExponent, 1.0 }, light->GetExponent())
    : 0.0;
  lamp.attenuation = AttenuationOf(light, check);
  TakeColors(light, check, lamp);
  return lamp;
}

// From very far away a lamp shines in the same direction, and with the same strength, on all places
// of a scene.
Lamp AtInfinityIfFar(Lamp lamp)
{
  const double distanceMm = LengthOf(lamp.position);
  if (!lamp.isNear || distanceMm < FarthestLampMm)
  {
    return lamp;
  }
  const glm::dvec3 towardsScene = -DirectionOf(lamp.position);
  const double inCone = glm::dot(towardsScene, lamp.shinesAlong);
  const glm::dvec3& attenuation = lamp.attenuation;
  const double weakened =
    1.0 / (attenuation.x + distanceMm * (attenuation.y + distanceMm * attenuation.z));
  const double reach = inCone >= lamp.coneCosine
    ? weakened * std::pow(std::clamp(inCone, 1e-6, 1.0), lamp.exponent)
    : 0.0;
  lamp.isNear = false;
  lamp.shinesAlong = towardsScene;
  lamp.diffuse *= reach;
  lamp.specular *= reach;
  return lamp;
}

void AddTexels(const Lamp& lamp, std::vector<glm::vec4>& texels)
{
  texels.emplace_back(lamp.isNear ? lamp.position : -lamp.shinesAlong, lamp.coneHeight);
  texels.emplace_back(lamp.diffuse, lamp.coneCosine);
  texels.emplace_back(lamp.specular, lamp.exponent);
  texels.emplace_back(lamp.attenuation, 0.0);
  texels.emplace_back(lamp.shinesAlong, 0.0);
}

LightTexels TexelsOf(const std::vector<Lamp>& lamps)
{
  LightTexels lights;
  std::vector<glm::vec4> texels;
  const auto add = [&](bool isNear, int& count)
  {
    for (const Lamp& lamp : lamps)
    {
      if (lamp.isNear == isNear)
      {
        AddTexels(lamp, texels);
        ++count;
      }
    }
  };
  add(false, lights.distantCount);
  add(true, lights.nearCount);
  lights.texels = texels.empty() ? lights.texels : texels;
  return lights;
}

}

SceneLights LightsOf(vtkRenderer* renderer, NumberCheck& check)
{
  SceneLights lights;
  lights.areTwoSided = renderer->GetTwoSidedLighting() != 0;
  glm::dvec3 ambient(0.0);
  std::vector<Lamp> lamps;
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    Lamp lamp = {};
    if (IsPlainHeadLight(light))
    {
      TakeColors(light, check, lamp);
      lights.head.diffuse += lamp.diffuse;
      lights.head.specular += lamp.specular;
    }
    else if (const std::optional<Lamp> other = LampOf(light, check))
    {
      lamp = AtInfinityIfFar(*other);
      lamps.push_back(lamp);
      lights.areHeadLights = false;
    }
    ambient += lamp.ambient;
  }
  lights.ambient = lights.areHeadLights ? glm::dvec3(1.0) : ambient;
  lights.lamps = TexelsOf(lamps);
  return lights;
}

int RaysToLights(const LightTexels& lights)
{
  int rays = 0;
  for (int light = 0; light < lights.Count(); ++light)
  {
    rays += lights.texels[std::size_t(light) * LightTexels::PerLight].w > 0.0f ? ConeDirections : 1;
  }
  return rays;
}

}
