#include "Regression/RegressionCase.h"

#include "Module/ProcessorMarching.h"
#include "Module/ReferenceMaterials.h"

#include <vtkPlane.h>

namespace
{

// Crops each axis to the middle half of the image's bounds, off all voxels.
void Crop(MapperScene& scene, int flags)
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
        Crop(scene, VTK_CROP_SUBVOLUME);
      }),
    TorsoCase("CroppingToRegions",
      [](MapperScene& scene)
      {
        ShowTissue(scene);
        Crop(scene, VTK_CROP_INVERTED_CROSS);
      }),
    TorsoCase("ClippingPlanes", ClipTwice),
    MaterialCase("ClippedVoxelIntensity", ClipAsSurface, MaterialWithClippedIntensity),
  };
}
