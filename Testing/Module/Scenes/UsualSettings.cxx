#include "Module/Scenes/UsualSettings.h"

#include <vtkLight.h>

vtkLight* AddLight(vtkRenderer* renderer, glm::dvec3 position, glm::dvec3 focus)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(focus.x, focus.y, focus.z);
  renderer->AddLight(light);
  return light;
}

void UseSunAndLamp(vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  vtkLight* const sun = AddLight(renderer, { 1.0, -0.5, 2.0 }, glm::dvec3(0.0));
  sun->SetDiffuseColor(1.0, 0.5, 0.2);
  vtkLight* const lamp = AddLight(renderer, { -60.0, -250.0, 30.0 }, glm::dvec3(0.0));
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetSpecularColor(0.2, 0.5, 1.0);
}

void CropToMiddle(MapperScene& scene, int flags)
{
  double bounds[6];
  scene.image->GetBounds(bounds);
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    const double part = i % 2 == 0 ? 0.27 : 0.71;
    planes[i] = bounds[i / 2 * 2] + part * (bounds[i / 2 * 2 + 1] - bounds[i / 2 * 2]);
  }
  scene.mapper->CroppingOn();
  scene.mapper->SetCroppingRegionPlanes(planes);
  scene.mapper->SetCroppingRegionFlags(flags);
}

void CastShadowsOfSunAndLamp(MapperScene& scene)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetSpecular(0.2);
  property->SetSpecularPower(5.0);
  scene.mapper->ShadowsOn();
  UseSunAndLamp(scene.renderer);
}
