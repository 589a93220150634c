#include "Stages/ExtremeScenes.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace extreme
{

namespace
{

// Smooth, asymmetric lumps from 0 to 1, independent of the number of voxels.
double Lumps(double x, double y, double z)
{
  return 0.5 + 0.25 * std::sin(5.0 * x + 2.0 * y) + 0.25 * std::cos(4.0 * y - 3.0 * z + 1.0);
}

// A volume centred at the origin, with values from `first` to `first + range`.
vtkSmartPointer<vtkImageData> LumpyImage(
  Dimensions dimensions, int type, double first, double range, Spacing spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.data());
  image->SetSpacing(spacing.data());
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = -0.5 * (dimensions[axis] - 1) * spacing[axis];
  }
  image->SetOrigin(origin);
  image->AllocateScalars(type, 1);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  vtkIdType index = 0;
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x)
      {
        const double lumps = Lumps(double(x) / std::max(dimensions[0] - 1, 1),
          double(y) / std::max(dimensions[1] - 1, 1), double(z) / std::max(dimensions[2] - 1, 1));
        scalars->SetComponent(index++, 0, first + range * lumps);
      }
    }
  }
  return image;
}

void SetOpacities(VolumeStage& scene, const std::vector<Node>& nodes)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AllowDuplicateScalarsOn();
  for (const Node& node : nodes)
  {
    scene.opacities->AddPoint(node.value, node.opacity);
  }
}

void SetColors(VolumeStage& scene, double first, double last)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(first, 0.1, 0.5, 1.0);
  scene.colors->AddRGBPoint(last, 1.0, 0.6, 0.1);
}

}

Image Lumpy(Dimensions dimensions, int type, double first, double range, Spacing spacing)
{
  return [=] { return LumpyImage(dimensions, type, first, range, spacing); };
}

Image LumpyWith(double value, const std::vector<Dimensions>& voxels, Dimensions dimensions)
{
  return [=]
  {
    auto image = LumpyImage(dimensions, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1.0 });
    for (const auto& [x, y, z] : voxels)
    {
      image->SetScalarComponentFromDouble(x, y, z, 0, value);
    }
    return image;
  };
}

Image Constant(double value, int type)
{
  return Lumpy(SmallBox, type, value, 0.0);
}

Preparation Opacities(const std::vector<Node>& nodes, double first, double last)
{
  return [=](VolumeStage& scene)
  {
    SetColors(scene, first, last);
    SetOpacities(scene, nodes);
  };
}

Preparation LookAt(double first, double range, double opacity)
{
  return Opacities(
    { { first + 0.4 * range, 0.0 }, { first + range, opacity } }, first, first + range);
}

void UsualLook(VolumeStage& scene)
{
  LookAt(0.0, 1.0)(scene);
}

void DenseLook(VolumeStage& scene)
{
  LookAt(0.0, 1.0, 0.9)(scene);
}

Preparation UnitDistance(double distanceMm)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    scene.volume->GetProperty()->SetScalarOpacityUnitDistance(distanceMm);
  };
}

Preparation SeenFrom(const Viewpoint& view)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetPosition(view.position.data());
    camera->SetFocalPoint(view.focalPoint.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(view.angle);
    camera->SetClippingRange(view.clippingRange[0], view.clippingRange[1]);
  };
}

Preparation SeenAlong(std::array<double, 3> direction, double sideVoxels)
{
  return [=](VolumeStage& scene)
  {
    SeenFrom({ { -50.0 * direction[0], -50.0 * direction[1], -50.0 * direction[2] },
      { 0.0, 0.0, 0.0 } })(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetViewUp(0.0, direction[2] == 0.0 ? 0.0 : 1.0, direction[2] == 0.0 ? 1.0 : 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * scene.size * sideVoxels);
  };
}

}

using namespace extreme;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double OneUlpOfOne = std::numeric_limits<double>::epsilon();
constexpr double SmallestNumber = std::numeric_limits<double>::denorm_min();
const double OneUlpBelowOne = std::nextafter(1.0, 0.0);

Preparation SampledEvery(double distance)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    scene.mapper->SetErrorTolerance(0.0);
    scene.mapper->AutoAdjustSampleDistancesOff();
    scene.mapper->SetSampleDistance(distance);
  };
}

Preparation NanColor(double opacity)
{
  return [=](VolumeStage& scene)
  {
    UsualLook(scene);
    scene.mapper->SetNanColor(0.1, 1.0, 0.3);
    scene.mapper->SetNanOpacity(opacity);
  };
}

}

std::vector<ExtremeScene> ExtremeMaterials()
{
  return {
    { "ExtinctionOf1e-12", Lumpy(), UnitDistance(1e12) },
    { "ExtinctionOf1e-6", Lumpy(), UnitDistance(1e6) },
    { "ExtinctionOf1e-3", Lumpy(), UnitDistance(1e3) },
    { "ExtinctionOf1e3", Lumpy(), UnitDistance(1e-3) },
    { "OpaqueAtTheEndOfARamp", Lumpy(), Opacities({ { 0.3, 0.0 }, { 0.8, 1.0 } }) },
    { "HazeOfOneUlp", Lumpy(), Opacities({ { 0.0, OneUlpOfOne }, { 1.0, OneUlpOfOne } }) },
    { "HazeOfTheSmallestNumber", Lumpy(),
      Opacities({ { 0.0, SmallestNumber }, { 1.0, SmallestNumber } }) },
    { "OneUlpFromOpaqueEverywhere", Lumpy(),
      Opacities({ { 0.0, OneUlpBelowOne }, { 1.0, OneUlpBelowOne } }) },
    { "OneUlpFromOpaqueAtTheEndOfARamp", Lumpy(),
      Opacities({ { 0.3, 0.0 }, { 0.8, OneUlpBelowOne } }) },
    { "OpaqueAtTheTipOfATent", Lumpy(SmallBox, VTK_UNSIGNED_SHORT, 0.0, 65535.0),
      Opacities({ { 0.0, 0.0 }, { 30000.0, 1.0 }, { 61380.0, 0.0 } }, 0.0, 65535.0) },
    { "OpaqueEverywhere", Lumpy(), Opacities({ { 0.0, 1.0 }, { 1.0, 1.0 } }) },
    { "PeakNarrowerThanATexelOf16Bits", Lumpy(SmallBox, VTK_UNSIGNED_SHORT, 0.0, 65535.0),
      Opacities({ { 30000.2, 0.0 }, { 30000.5, 0.9 }, { 30000.8, 0.0 } }, 0.0, 65535.0) },
    { "PeakOf16Bits", Lumpy(SmallBox, VTK_UNSIGNED_SHORT, 0.0, 65535.0),
      Opacities({ { 30000.0, 0.0 }, { 30001.0, 0.9 }, { 30002.0, 0.0 } }, 0.0, 65535.0) },
    { "OpacitiesOfAMillionToOne", Lumpy(),
      Opacities({ { 0.0, 1e-6 }, { 0.5, 1e-6 }, { 0.6, 0.999999 }, { 1.0, 0.999999 } }) },
  };
}

std::vector<ExtremeScene> HardSurfaces()
{
  return {
    { "ExtinctionOf1e6", Lumpy(), UnitDistance(1e-6) },
    { "ExtinctionOf1e12", Lumpy(), UnitDistance(1e-12) },
    { "OpaquePeakNarrowerThanATexel", Lumpy(SmallBox, VTK_UNSIGNED_SHORT, 0.0, 65535.0),
      [](VolumeStage& scene)
      {
        Opacities({ { 30000.2, 0.0 }, { 30000.5, 0.9 }, { 30000.8, 0.0 } }, 0.0, 65535.0)(scene);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1e-6);
      } },
    { "OpaqueAboveAStep", Lumpy(), Opacities({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.5, 1.0 } }) },
    { "OneUlpFromOpaque", Lumpy(),
      Opacities({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.5, OneUlpBelowOne }, { 1.0, OneUlpBelowOne } }) },
    { "StepsOnly", Lumpy(),
      Opacities(
        { { 0.3, 0.0 }, { 0.3, 0.2 }, { 0.6, 0.2 }, { 0.6, 0.05 }, { 0.8, 0.05 }, { 0.8, 0.9 } }) },
    { "HazeBeforeAWall", Lumpy(),
      Opacities({ { 0.0, 1e-6 }, { 0.7, 1e-6 }, { 0.7, 1.0 }, { 1.0, 1.0 } }) },
  };
}

std::vector<ExtremeScene> ExtremeScalars()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Dimensions> some = { { 3, 4, 5 }, { 8, 2, 7 }, { 0, 0, 0 }, { 5, 8, 9 } };
  std::vector<Dimensions> all;
  for (int i = 0; i < SmallBox[0] * SmallBox[1] * SmallBox[2]; ++i)
  {
    all.push_back(
      { i % SmallBox[0], i / SmallBox[0] % SmallBox[1], i / SmallBox[0] / SmallBox[1] });
  }
  return {
    { "RangeOf1e-30", Lumpy(SmallBox, VTK_DOUBLE, 0.0, 1e-30), LookAt(0.0, 1e-30) },
    { "RangeOf1e-30InFloats", Lumpy(SmallBox, VTK_FLOAT, 0.0, 1e-30), LookAt(0.0, 1e-30) },
    { "RangeOf1e30InDoubles", Lumpy(SmallBox, VTK_DOUBLE, -5e29, 1e30), LookAt(-5e29, 1e30) },
    { "RangeOf1e30", Lumpy(SmallBox, VTK_FLOAT, -5e29, 1e30), LookAt(-5e29, 1e30) },
    { "VariationOf1At1e7", Lumpy(SmallBox, VTK_DOUBLE, 1e7, 1.0), LookAt(1e7, 1.0) },
    { "ConstantZero", Constant(0.0), Opacities({ { 0.0, 0.05 } }) },
    { "ConstantInsideTheRamp", Constant(0.6), UsualLook },
    { "ConstantDouble", Constant(1e7, VTK_DOUBLE), LookAt(1e7 - 1.0, 2.0) },
    { "ConstantShort", Constant(-32768.0, VTK_SHORT), LookAt(-32769.0, 2.0) },
    { "ConstantUnsignedShort", Constant(65535.0, VTK_UNSIGNED_SHORT), LookAt(65534.0, 2.0) },
    { "ConstantChar", Constant(-128.0, VTK_SIGNED_CHAR), LookAt(-129.0, 2.0) },
    { "ConstantUnsignedChar", Constant(255.0, VTK_UNSIGNED_CHAR), LookAt(254.0, 2.0) },
    { "NotANumber", LumpyWith(nan, some), UsualLook },
    { "PlusInfinity", LumpyWith(infinity, some), UsualLook },
    { "MinusInfinity", LumpyWith(-infinity, some), UsualLook },
    { "NotANumberInADenseVolume", LumpyWith(nan, some), DenseLook },
    { "NotANumberInAColor", LumpyWith(nan, some), NanColor(0.3) },
    { "NotANumberInAnOpaqueColor", LumpyWith(nan, some), NanColor(1.0) },
    { "NothingButNotANumber", LumpyWith(nan, all), UsualLook },
    { "NothingButInfinity", LumpyWith(infinity, all), UsualLook },
  };
}

std::vector<ExtremeScene> ExtremesWithoutTolerance()
{
  return {
    // Behind a veil that the samples cross, the visible material rises in the last cell. Any error
    // in the position along the ray shows in the image.
    { "EighteenThousandSteps",
      LumpyWith(10.0,
        { { 2000, 0, 0 }, { 2000, 1, 0 }, { 2000, 2, 0 }, { 2000, 0, 1 }, { 2000, 1, 1 },
          { 2000, 2, 1 }, { 2000, 0, 2 }, { 2000, 1, 2 }, { 2000, 2, 2 } },
        { 2001, 3, 3 }),
      [](VolumeStage& scene)
      {
        SampledEvery(1.0 / 9.0)(scene);
        SeenFrom({ { -1100.0, 0.2, 0.1 }, { 0.0, 0.0, 0.0 }, 0.15, { 1.0, 1e4 } })(scene);
        Opacities({ { -1.0, 1e-6 }, { 5.0, 1e-6 }, { 10.0, 0.9 } }, 0.0, 10.0)(scene);
      } },
    { "StepLongerThanTheVolume", Lumpy(), SampledEvery(1e6) },
    { "StepOf1e30", Lumpy(), SampledEvery(1e30) },
    { "StepOf1e-4Voxels", Lumpy({ 2, 2, 2 }), SampledEvery(1e-4) },
    { "StepOf1e-30", Lumpy({ 2, 2, 2 }), SampledEvery(1e-30) },
  };
}

std::unique_ptr<VolumeStage> StageOf(
  const ExtremeScene& extreme, int size, vtkHeadlessRenderWindow* window)
{
  auto stage = std::make_unique<VolumeStage>(extreme.image(), size, window);
  extreme.prepare(*stage);
  return stage;
}

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
