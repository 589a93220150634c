#include "Stages/ExtremeSceneParts.h"

#include <vtkCamera.h>

#include <cmath>
#include <limits>

namespace varimarch
{

using namespace extreme;

namespace
{

Preparation Scaled(double scale)
{
  return [scale](VolumeStage& scene)
  {
    UsualLook(scene);
    scene.volume->SetScale(scale);
    scene.volume->GetProperty()->SetScalarOpacityUnitDistance(scale);
    scene.renderer->ResetCamera();
  };
}

Preparation UnitDistanceSeenObliquely(double distanceMm)
{
  return [=](VolumeStage& scene)
  {
    UnitDistance(distanceMm)(scene);
    scene.renderer->GetActiveCamera()->SetPosition(0.3, -1.0, 0.4);
    scene.renderer->ResetCamera();
  };
}

void LookThroughTheFront(VolumeStage& scene)
{
  DenseLook(scene);
  scene.renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 10.0);
  scene.renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
  scene.renderer->ResetCamera();
}

}

std::vector<ExtremeScene> ThinShapes()
{
  return {
    { "OneVoxelThick", Lumpy({ 11, 9, 1 }), DenseLook },
    { "OneVoxelThickFromItsFront", Lumpy({ 11, 9, 1 }), LookThroughTheFront },
    { "OneVoxelThickInX", Lumpy({ 1, 9, 10 }), DenseLook },
    { "OneVoxelThickInY", Lumpy({ 11, 1, 10 }), DenseLook },
    { "OneRowOfVoxels", Lumpy({ 11, 1, 1 }), DenseLook },
    { "OneColumnOfVoxels", Lumpy({ 1, 1, 10 }), DenseLook },
    { "OneVoxelThickInTwoAxes", Lumpy({ 1, 9, 1 }), DenseLook },
    { "OneVoxel", Lumpy({ 1, 1, 1 }), DenseLook },
    { "OneVoxelOfNotANumber", LumpyWith(std::nan(""), { { 0, 0, 0 } }, { 1, 1, 1 }), DenseLook },
  };
}

std::vector<ExtremeScene> ExtremeShapes()
{
  return {
    { "StretchedAThousandTimes", Lumpy({ 11, 9, 2 }, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1000.0 }),
      [](VolumeStage& scene)
      {
        SeenFrom({ { 12.0, 9.0, -8000.0 }, { 0.0, 0.0, 0.0 }, 0.1, { 1.0, 1e5 } })(scene);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1000.0);
      } },
    { "StretchedAndSeenFromTheSide", Lumpy({ 11, 9, 2 }, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1000.0 }),
      [](VolumeStage& scene) {
        SeenFrom({ { 30.0, 20.0, 300.0 }, { 0.0, 0.0, 200.0 }, 30.0, { 1.0, 1e5 } })(scene);
      } },
    { "StretchedAThousandTimesInTwoAxes",
      Lumpy({ 3, 9, 3 }, VTK_FLOAT, 0.0, 1.0, { 1000.0, 1.0, 1000.0 }),
      [](VolumeStage& scene) {
        SeenFrom({ { 300.0, -30.0, 200.0 }, { 280.0, 0.0, 210.0 }, 30.0, { 1.0, 1e5 } })(scene);
      } },
    { "StretchedAThousandTimesSeenAlong",
      Lumpy({ 2, 9, 10 }, VTK_FLOAT, 0.0, 1.0, { 1000.0, 1.0, 1.0 }),
      [](VolumeStage& scene)
      {
        SeenAlong({ 1.0, 0.0, 0.0 }, 0.25)(scene);
        scene.renderer->GetActiveCamera()->SetPosition(-2000.0, 0.0, 0.0);
        scene.renderer->GetActiveCamera()->SetClippingRange(1.0, 1e4);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1000.0);
      } },
    { "SpacedBy1e6", Lumpy(SmallBox, VTK_FLOAT, 0.0, 1.0, { 1e6, 1e6, 1e6 }),
      UnitDistanceSeenObliquely(1e6) },
    { "ScaledBy1e-6", Lumpy(), Scaled(1e-6) },
    { "ScaledBy1e6", Lumpy(), Scaled(1e6) },
    { "SpacedBy1e-6", Lumpy(SmallBox, VTK_FLOAT, 0.0, 1.0, { 1e-6, 1e-6, 1e-6 }),
      UnitDistanceSeenObliquely(1e-6) },
    { "FarFromTheOrigin", Lumpy(),
      [](VolumeStage& scene)
      {
        UsualLook(scene);
        scene.volume->SetPosition(1e5, -1e5, 1e5);
        scene.renderer->ResetCamera();
      } },
  };
}

std::vector<ExtremeScene> ExtremeViews()
{
  const double diagonal = std::sqrt(1.0 / 3.0);
  return {
    { "RaysAlongX", Lumpy(), SeenAlong({ 1.0, 0.0, 0.0 }) },
    { "RaysAlongY", Lumpy(), SeenAlong({ 0.0, 1.0, 0.0 }) },
    { "RaysAgainstZ", Lumpy(), SeenAlong({ 0.0, 0.0, -1.0 }) },
    { "RaysAlongXShiftedByHalfAVoxel", Lumpy({ 10, 10, 11 }), SeenAlong({ -1.0, 0.0, 0.0 }, 1.0) },
    { "RaysThroughCorners", Lumpy({ 9, 9, 9 }), SeenAlong({ diagonal, diagonal, diagonal }) },
    { "RaysThroughEdges", Lumpy({ 9, 9, 9 }), SeenAlong({ std::sqrt(0.5), -std::sqrt(0.5), 0.0 }) },
    { "CameraInside", Lumpy(), SeenFrom({ { 0.3, 0.2, 0.1 }, { 4.0, 1.0, 1.0 }, 90.0 }) },
    { "CameraOnAFace", Lumpy(), SeenFrom({ { -5.0, 0.3, 0.2 }, { 5.0, 0.0, 0.0 }, 90.0 }) },
    { "CameraAtAVoxel", Lumpy(), SeenFrom({ { 1.0, 1.0, 0.5 }, { 5.0, 1.0, 0.5 }, 90.0 }) },
    { "CameraAtACorner", Lumpy(), SeenFrom({ { -5.0, -4.0, -4.5 }, { 0.0, 0.0, 0.0 }, 90.0 }) },
    { "NearPlaneThroughTheMiddle", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 30.0, 100.0 } }) },
    { "FarPlaneThroughTheMiddle", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 1.0, 30.0 } }) },
    { "ViewAngleOfATenthOfADegree", Lumpy(),
      SeenFrom({ { -5000.0, 3000.0, 2000.0 }, { 0.0, 0.0, 0.0 }, 0.1, { 1.0, 1e4 } }) },
    { "ViewAngleOf170Degrees", Lumpy(),
      SeenFrom({ { -8.0, 1.0, 1.0 }, { 0.0, 0.0, 0.0 }, 170.0 }) },
    { "ViewAngleOf170DegreesInside", Lumpy(),
      SeenFrom({ { 0.3, 0.2, 0.1 }, { 4.0, 1.0, 1.0 }, 170.0 }) },
    { "NearPlaneThroughTheMiddleInside", Lumpy(),
      SeenFrom({ { 0.3, 0.2, 0.1 }, { 4.0, 1.0, 1.0 }, 90.0, { 2.0, 100.0 } }) },
    { "ClippedToNothingInFront", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 50.0, 100.0 } }) },
    { "ClippedToNothingBehind", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 1.0, 10.0 } }) },
    { "BehindTheCamera", Lumpy(), SeenFrom({ { -30.0, 3.0, 2.0 }, { -40.0, 0.0, 0.0 } }) },
  };
}

}
