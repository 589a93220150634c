#include "Regression/RegressionCase.h"

#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/SliceTruth.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkImplicitFunction.h>
#include <vtkPlane.h>
#include <vtkSphere.h>

namespace
{

// Opacity from a value to another, for projections.
void ShowRange(MapperScene& scene, double clear, double opaque)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(clear, 0.0);
  scene.opacities->AddPoint(opaque, 1.0);
}

void MaximumIntensity(MapperScene& scene)
{
  scene.mapper->SetBlendModeToMaximumIntensity();
  ShowRange(scene, -1000.0, 1200.0);
}

// In a box inside the body, for rays that begin in the air around it all have the least value
// there.
void MinimumIntensity(MapperScene& scene)
{
  scene.mapper->SetBlendModeToMinimumIntensity();
  CropToMiddle(scene, VTK_CROP_SUBVOLUME);
  ShowRange(scene, 300.0, -900.0);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(-900.0, 0.2, 0.6, 1.0);
  scene.colors->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
  scene.colors->AddRGBPoint(200.0, 1.0, 1.0, 0.8);
  scene.renderer->GetActiveCamera()->Zoom(1.8);
}

void AverageIntensity(MapperScene& scene)
{
  scene.mapper->SetBlendModeToAverageIntensity();
  scene.mapper->SetAverageIPScalarRange(-300.0, 3000.0);
  ShowRange(scene, -300.0, 200.0);
}

void Additive(MapperScene& scene)
{
  scene.mapper->SetBlendModeToAdditive();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-500.0, 0.0);
  scene.opacities->AddPoint(500.0, 0.01);
}

RegressionScene SliceBy(vtkImplicitFunction* function)
{
  const auto scene = NewScene(SmallTorso());
  scene->mapper->SetBlendModeToSlice();
  scene->volume->GetProperty()->SetSliceFunction(function);
  ShowRange(*scene, -1000.0, 100.0);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene] { return SliceTruth(*scene); };
  return regression;
}

RegressionScene SliceByPlane()
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(3.0, 4.0, 5.0);
  plane->SetNormal(0.3, -0.8, 0.6);
  return SliceBy(plane);
}

RegressionScene SliceBySphere()
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(5.0, -8.0, 3.0);
  sphere->SetRadius(110.0);
  return SliceBy(sphere);
}

}

std::vector<RegressionCase> BlendCases()
{
  // A ray that grazes a surface shows it or not, as rounding decides.
  constexpr double grazed = 30.0;
  RegressionCase isosurfaces = TorsoCase("Isosurfaces", ShowIsosurfaces);
  isosurfaces.allowed999 = grazed;
  return {
    TorsoCase("Composite", [](MapperScene&) {}),
    TorsoCase("MaximumIntensity", MaximumIntensity),
    TorsoCase("MinimumIntensity", MinimumIntensity),
    TorsoCase("AverageIntensity", AverageIntensity),
    TorsoCase("Additive", Additive),
    isosurfaces,
    { "SliceByPlane", SliceByPlane },
    { "SliceBySphere", SliceBySphere },
  };
}
