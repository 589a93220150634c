#include "Frame/Lights.h"

#include "vtkVariationFieldVolumeMapper.h"

#include "Core/Geometry/LightCone.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// A cone this wide does not limit the light, as in OpenGL.
constexpr double WidestConeDegrees = 90.0;
constexpr double NoCone = -2.0; // less than any cosine

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

bool HasPlainHeadLightsOnly(vtkRenderer* renderer)
{
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    if (!IsPlainHeadLight(light))
    {
      return false;
    }
  }
  return true;
}

glm::dvec3 Vector(const double* values)
{
  return { values[0], values[1], values[2] };
}

double ConeHeightOf(vtkLight* light)
{
  constexpr double MostDegrees = 90.0;
  vtkInformation* const information = light->GetInformation();
  vtkInformationDoubleKey* const key = vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS();
  const double degrees = information && information->Has(key) ? information->Get(key) : 0.0;
  return 1.0 - std::cos(glm::radians(std::clamp(degrees, 0.0, MostDegrees)));
}

void AddTexels(std::vector<glm::vec4>& texels, vtkLight* light)
{
  const glm::dvec3 position = Vector(light->GetTransformedPosition());
  const glm::dvec3 shinesAlong = Vector(light->GetTransformedFocalPoint()) - position;
  const double reach = glm::length(shinesAlong);
  const glm::dvec3 direction = reach > 0.0 ? shinesAlong / reach : glm::dvec3(0.0);
  const bool cone = light->GetConeAngle() < WidestConeDegrees;
  const double intensity = light->GetIntensity();
  texels.emplace_back(light->GetPositional() ? position : -direction, ConeHeightOf(light));
  texels.emplace_back(intensity * Vector(light->GetDiffuseColor()),
    cone ? std::cos(glm::radians(light->GetConeAngle())) : NoCone);
  texels.emplace_back(
    intensity * Vector(light->GetSpecularColor()), cone ? light->GetExponent() : 0.0);
  texels.emplace_back(Vector(light->GetAttenuationValues()), 0.0);
  texels.emplace_back(direction, 0.0);
}

}

HeadLightColors HeadLightColorsOf(vtkRenderer* renderer)
{
  HeadLightColors sum;
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    if (IsPlainHeadLight(light))
    {
      sum.diffuse += light->GetIntensity() * Vector(light->GetDiffuseColor());
      sum.specular += light->GetIntensity() * Vector(light->GetSpecularColor());
    }
  }
  return sum;
}

bool HasHeadLightOnly(vtkRenderer* renderer)
{
  return renderer->GetTwoSidedLighting() && HasPlainHeadLightsOnly(renderer);
}

glm::dvec3 AmbientLightOf(vtkRenderer* renderer)
{
  if (HasPlainHeadLightsOnly(renderer))
  {
    return glm::dvec3(1.0);
  }
  glm::dvec3 sum(0.0);
  for (vtkLight* light : LightsThatAreOn(renderer))
  {
    sum += light->GetIntensity() * Vector(light->GetAmbientColor());
  }
  return sum;
}

LightTexels LightTexelsOf(vtkRenderer* renderer)
{
  LightTexels lights;
  const auto add = [&](bool near, int& count)
  {
    for (vtkLight* light : LightsThatAreOn(renderer))
    {
      if (!IsPlainHeadLight(light) && (light->GetPositional() != 0) == near)
      {
        AddTexels(lights.texels, light);
        ++count;
      }
    }
  };
  add(false, lights.distantCount);
  add(true, lights.nearCount);
  if (lights.texels.empty())
  {
    lights.texels.emplace_back(0.0f);
  }
  return lights;
}

int RaysToLights(const LightTexels& lights)
{
  int rays = 0;
  for (int light = 0; light < lights.distantCount + lights.nearCount; ++light)
  {
    rays += lights.texels[std::size_t(light) * LightTexels::PerLight].w > 0.0f ? ConeDirections : 1;
  }
  return rays;
}

}
