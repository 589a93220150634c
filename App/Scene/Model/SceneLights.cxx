#include "Scene/Model/SceneLights.h"

#include "Scene/Model/WorldVector.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// In the space of VTK's camera lights, the eye is at (0, 0, 1) and looks at the origin.
void Place(const SceneLight& light, vtkLight* placed)
{
  switch (light.kind)
  {
    case LightKind::Head:
      placed->SetLightTypeToHeadlight();
      break;
    case LightKind::Camera:
    case LightKind::Directional:
      light.kind == LightKind::Camera ? placed->SetLightTypeToCameraLight()
                                      : placed->SetLightTypeToSceneLight();
      placed->SetPosition(light.direction.data());
      placed->SetFocalPoint(0.0, 0.0, 0.0);
      break;
    case LightKind::Positional:
      placed->SetLightTypeToSceneLight();
      placed->PositionalOn();
      placed->SetPosition(light.positionMm.data());
      placed->SetConeAngle(180.0);
      break;
  }
}

vtkSmartPointer<vtkLight> VtkLightOf(const SceneLight& light, double ambient)
{
  auto placed = vtkSmartPointer<vtkLight>::New();
  Place(light, placed);
  placed->SetDiffuseColor(light.rgb.data());
  placed->SetSpecularColor(light.rgb.data());
  placed->SetIntensity(light.intensity);
  if (light.softnessDegrees > 0.0)
  {
    placed->GetInformation()->Set(
      vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), light.softnessDegrees);
  }
  placed->SetAmbientColor(ambient, ambient, ambient);
  return placed;
}

}

SceneLight CameraLight(double azimuthDegrees, double elevationDegrees)
{
  SceneLight light;
  light.kind = LightKind::Camera;
  light.direction = DirectionOf({ azimuthDegrees, elevationDegrees }, LightKind::Camera);
  return light;
}

Lighting LightingOf(const Scene& scene)
{
  return { scene.lights, scene.shadows, scene.scattering, scene.occlusion };
}

void TakeLighting(const Lighting& lighting, Scene& scene)
{
  scene.lights = lighting.lights;
  scene.shadows = lighting.shadows;
  scene.scattering = lighting.scattering;
  scene.occlusion = lighting.occlusion;
}

LightAngles AnglesOf(const std::array<double, 3>& direction, LightKind kind)
{
  const glm::dvec3 towards = glm::normalize(VectorOf(direction));
  const glm::dvec3 local =
    kind == LightKind::Camera ? towards : glm::dvec3(towards.x, towards.z, -towards.y);
  return { glm::degrees(std::atan2(local.x, local.z)),
    glm::degrees(std::asin(std::clamp(local.y, -1.0, 1.0))) };
}

std::array<double, 3> DirectionOf(const LightAngles& angles, LightKind kind)
{
  const double azimuth = glm::radians(angles.azimuthDegrees);
  const double elevation = glm::radians(angles.elevationDegrees);
  const glm::dvec3 local(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
    std::cos(azimuth) * std::cos(elevation));
  return NumbersOf(kind == LightKind::Camera ? local : glm::dvec3(local.x, -local.z, local.y));
}

void SetLights(const std::vector<SceneLight>& lights, vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  renderer->SetAutomaticLightCreation(lights.empty());
  renderer->SetTwoSidedLighting(std::all_of(lights.begin(), lights.end(),
    [](const SceneLight& light) { return light.kind == LightKind::Head; }));
  for (const SceneLight& light : lights)
  {
    // A renderer multiplies the ambient colours by the intensities and adds them.
    renderer->AddLight(VtkLightOf(light, 1.0 / (double(lights.size()) * light.intensity)));
  }
}

}
