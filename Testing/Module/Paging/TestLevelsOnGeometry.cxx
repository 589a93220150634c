// The levels of volumes in their files in the shadows that they cast on opaque geometry.

#include "Module/Paging/RefinedLevels.h"
#include "Module/Scenes/CubeAboveFloor.h"
#include "Module/Scenes/UsualSettings.h"

#include <cmath>
#include <vector>

namespace
{

// A floor behind a volume, which is seen in parallel projection along -z.
vtkSmartPointer<vtkActor> FloorBehind(vtkVolume* volume)
{
  const double* const bounds = volume->GetBounds();
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1000.0, -1000.0, bounds[4] - 5.0);
  plane->SetPoint1(1000.0, -1000.0, bounds[4] - 5.0);
  plane->SetPoint2(-1000.0, 1000.0, bounds[4] - 5.0);
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(plane->GetOutputPort());
  const auto floor = vtkSmartPointer<vtkActor>::New();
  floor->SetMapper(faces);
  floor->GetProperty()->SetAmbient(0.0);
  floor->GetProperty()->SetDiffuse(0.8);
  return floor;
}

}

// A second volume, which casts no shadows, makes all volumes cast theirs together.
TEST_F(RefinedLevels, OfSeveralVolumesCastShadowsOnGeometryLikeThoseOfOne)
{
  MapperScene scene(this->ReadVoxels(Waves), 48);
  UseFog(scene, 0.0, 0.03);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->ShadowsOn();
  scene.mapper->SetErrorTolerance(0.0);
  scene.renderer->AutomaticLightCreationOff();
  scene.renderer->RemoveAllLights();
  AddLight(scene.renderer, { 0.0, 300.0, 400.0 }, glm::dvec3(0.0));
  scene.renderer->AddActor(FloorBehind(scene.volume));
  const double* const center = scene.volume->GetCenter();
  scene.LookDown({ center[0], center[1], 0.0 }, 0.6 * scene.volume->GetLength());
  const auto drawnBy = [&](int level)
  {
    scene.mapper->SetLevelOfDetail(level);
    return scene.DrawByProcessor();
  };
  const std::vector<float> voxels = drawnBy(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> coarse = drawnBy(vtkVariationFieldVolumeMapper::CoarseLevel);
  EXPECT_GT(voxels[0], 0.1f) << "the floor is not seen";
  EXPECT_GT(LargestDifference(voxels, coarse), 0.02) << "the level is not seen";
  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  mapper->SetInputData(DarkCube());
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetPosition(0.0, 0.0, center[2] + 2.0 * scene.volume->GetLength());
  other->GetProperty()->SetScalarOpacity(0, vtkNew<vtkPiecewiseFunction>());
  scene.renderer->AddVolume(other);
  EXPECT_EQ(drawnBy(vtkVariationFieldVolumeMapper::CoarseLevel), coarse);
  EXPECT_EQ(drawnBy(vtkVariationFieldVolumeMapper::VoxelLevel), voxels);
}
