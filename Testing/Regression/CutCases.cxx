#include "Regression/RegressionCase.h"

#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkPlane.h>

namespace
{

// Shows cuts everywhere, also in soft tissue.
void ShowTissue(MapperScene& scene)
{
  scene.opacities->AddPoint(0.0, 0.06);
  scene.opacities->AddPoint(150.0, 0.06);
}

void ClipTwice(MapperScene& scene)
{
  ShowTissue(scene);
  Clip(scene);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 30.0);
  plane->SetNormal(-0.4, 0.3, -1.0);
  scene.mapper->AddClippingPlane(plane);
}

void ClipAsSurface(MapperScene& scene)
{
  ClipTwice(scene);
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->UseClippedVoxelIntensityOn();
  scene.volume->GetProperty()->SetClippedVoxelIntensity(-1000.0);
}

}

std::vector<RegressionCase> CutCases()
{
  return {
    TorsoCase("CroppingToABox",
      [](MapperScene& scene)
      {
        ShowTissue(scene);
        CropToMiddle(scene, VTK_CROP_SUBVOLUME);
      }),
    TorsoCase("CroppingToRegions",
      [](MapperScene& scene)
      {
        ShowTissue(scene);
        CropToMiddle(scene, VTK_CROP_INVERTED_CROSS);
      }),
    TorsoCase("ClippingPlanes", ClipTwice),
    MaterialCase("ClippedVoxelIntensity", ClipAsSurface, MaterialWithClippedIntensity),
  };
}
