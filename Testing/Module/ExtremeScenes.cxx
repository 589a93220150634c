#include "Module/ExtremeScenes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

const double OneUlpBelowOne = std::nextafter(1.0, 0.0);

using Dimensions = std::array<int, 3>;

constexpr Dimensions SmallBox = { 11, 9, 10 };

// Smooth lumps from 0 to 1, the same whatever the number of voxels, and never symmetric.
double Lumps(double x, double y, double z)
{
  return 0.5 + 0.25 * std::sin(5.0 * x + 2.0 * y) + 0.25 * std::cos(4.0 * y - 3.0 * z + 1.0);
}

// Values from `first` to `first + range`, centred at the origin.
vtkSmartPointer<vtkImageData> LumpyImage(Dimensions dimensions, int type, double first,
  double range, std::array<double, 3> spacing = { 1.0, 1.0, 1.0 })
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

auto Lumpy(Dimensions dimensions = SmallBox, int type = VTK_FLOAT, double first = 0.0,
  double range = 1.0, std::array<double, 3> spacing = { 1.0, 1.0, 1.0 })
{
  return [=] { return LumpyImage(dimensions, type, first, range, spacing); };
}

auto LumpyWith(double value, const std::vector<std::array<int, 3>>& voxels)
{
  return [=]
  {
    auto image = LumpyImage(SmallBox, VTK_FLOAT, 0.0, 1.0);
    for (const auto& [x, y, z] : voxels)
    {
      image->SetScalarComponentFromDouble(x, y, z, 0, value);
    }
    return image;
  };
}

auto Constant(double value, int type = VTK_FLOAT)
{
  return [=] { return LumpyImage(SmallBox, type, value, 0.0); };
}

struct Node
{
  double value;
  double opacity;
};

void SetOpacities(MapperScene& scene, const std::vector<Node>& nodes)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AllowDuplicateScalarsOn();
  for (const Node& node : nodes)
  {
    scene.opacities->AddPoint(node.value, node.opacity);
  }
}

void SetColors(MapperScene& scene, double first, double last)
{
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(first, 0.1, 0.5, 1.0);
  scene.colors->AddRGBPoint(last, 1.0, 0.6, 0.1);
}

// Clear below the middle of the values, then a ramp of opacity.
void Look(MapperScene& scene, double first = 0.0, double range = 1.0, double opacity = 0.3)
{
  SetColors(scene, first, first + range);
  SetOpacities(scene, { { first + 0.4 * range, 0.0 }, { first + range, opacity } });
}

auto Opacities(const std::vector<Node>& nodes, double first = 0.0, double last = 1.0)
{
  return [=](MapperScene& scene)
  {
    SetColors(scene, first, last);
    SetOpacities(scene, nodes);
  };
}

auto LookAt(double first, double range)
{
  return [=](MapperScene& scene) { Look(scene, first, range); };
}

void UsualLook(MapperScene& scene)
{
  Look(scene);
}

auto UnitDistance(double distanceMm)
{
  return [=](MapperScene& scene)
  {
    Look(scene);
    scene.volume->GetProperty()->SetScalarOpacityUnitDistance(distanceMm);
  };
}

struct View
{
  std::array<double, 3> position;
  std::array<double, 3> focalPoint;
  double angle = 30.0;
  std::array<double, 2> clippingRange = { 0.01, 100.0 };
};

auto SeenFrom(const View& view)
{
  return [=](MapperScene& scene)
  {
    Look(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetPosition(view.position.data());
    camera->SetFocalPoint(view.focalPoint.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(view.angle);
    camera->SetClippingRange(view.clippingRange[0], view.clippingRange[1]);
  };
}

// Pixels half a voxel apart, so that rays run through voxels, along edges and in faces of cells.
auto SeenAlong(std::array<double, 3> direction, double sideVoxels = 0.5)
{
  return [=](MapperScene& scene)
  {
    SeenFrom({ { -50.0 * direction[0], -50.0 * direction[1], -50.0 * direction[2] },
      { 0.0, 0.0, 0.0 } })(scene);
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    camera->SetViewUp(0.0, direction[2] == 0.0 ? 0.0 : 1.0, direction[2] == 0.0 ? 1.0 : 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * scene.size * sideVoxels);
  };
}

auto SampledEvery(double distance)
{
  return [=](MapperScene& scene)
  {
    Look(scene);
    scene.mapper->SetErrorTolerance(0.0);
    scene.mapper->AutoAdjustSampleDistancesOff();
    scene.mapper->SetSampleDistance(distance);
  };
}

auto Scaled(double scale)
{
  return [scale](MapperScene& scene)
  {
    Look(scene);
    scene.volume->SetScale(scale);
    scene.volume->GetProperty()->SetScalarOpacityUnitDistance(scale);
    scene.renderer->ResetCamera();
  };
}

auto UnitDistanceSeenObliquely(double distanceMm)
{
  return [=](MapperScene& scene)
  {
    UnitDistance(distanceMm)(scene);
    scene.renderer->GetActiveCamera()->SetPosition(0.3, -1.0, 0.4);
    scene.renderer->ResetCamera();
  };
}

void DenseLook(MapperScene& scene)
{
  Look(scene, 0.0, 1.0, 0.9);
}

void LookThroughTheFront(MapperScene& scene)
{
  DenseLook(scene);
  scene.renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 10.0);
  scene.renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
  scene.renderer->ResetCamera();
}

vtkSmartPointer<vtkImageData> OneVoxelOfNotANumber()
{
  auto image = LumpyImage({ 1, 1, 1 }, VTK_FLOAT, 0.0, 1.0);
  image->SetScalarComponentFromDouble(0, 0, 0, 0, std::nan(""));
  return image;
}

}

std::vector<ExtremeScene> ExtremeMaterials()
{
  return {
    { "ExtinctionOf1e-12", Lumpy(), UnitDistance(1e12) },
    { "ExtinctionOf1e-3", Lumpy(), UnitDistance(1e3) },
    { "ExtinctionOf1e3", Lumpy(), UnitDistance(1e-3) },
    { "OpaqueAtTheEndOfARamp", Lumpy(), Opacities({ { 0.3, 0.0 }, { 0.8, 1.0 } }) },
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
  const std::vector<std::array<int, 3>> some = { { 3, 4, 5 }, { 8, 2, 7 }, { 0, 0, 0 },
    { 5, 8, 9 } };
  std::vector<std::array<int, 3>> all;
  for (int i = 0; i < SmallBox[0] * SmallBox[1] * SmallBox[2]; ++i)
  {
    all.push_back(
      { i % SmallBox[0], i / SmallBox[0] % SmallBox[1], i / SmallBox[0] / SmallBox[1] });
  }
  const auto spike = [](MapperScene& scene) { Look(scene, 0.0, 1.0, 0.9); };
  return {
    { "RangeOf1e-30", Lumpy(SmallBox, VTK_DOUBLE, 0.0, 1e-30), LookAt(0.0, 1e-30) },
    { "RangeOf1e30", Lumpy(SmallBox, VTK_FLOAT, -5e29, 1e30), LookAt(-5e29, 1e30) },
    { "VariationOf1At1e7", Lumpy(SmallBox, VTK_DOUBLE, 1e7, 1.0), LookAt(1e7, 1.0) },
    { "ConstantZero", Constant(0.0), Opacities({ { 0.0, 0.05 } }) },
    { "ConstantInsideTheRamp", Constant(0.6), UsualLook },
    { "NotANumber", LumpyWith(nan, some), UsualLook },
    { "PlusInfinity", LumpyWith(infinity, some), UsualLook },
    { "MinusInfinity", LumpyWith(-infinity, some), UsualLook },
    { "NotANumberInADenseVolume", LumpyWith(nan, some), spike },
    { "NothingButNotANumber", LumpyWith(nan, all), UsualLook },
    { "NothingButInfinity", LumpyWith(infinity, all), UsualLook },
  };
}

std::vector<ExtremeScene> ThinShapes()
{
  return {
    { "OneVoxelThick", Lumpy({ 11, 9, 1 }), DenseLook },
    { "OneVoxelThickFromItsFront", Lumpy({ 11, 9, 1 }), LookThroughTheFront },
    { "OneVoxelThickInTwoAxes", Lumpy({ 1, 9, 1 }), DenseLook },
    { "OneVoxel", Lumpy({ 1, 1, 1 }), DenseLook },
    { "OneVoxelOfNotANumber", OneVoxelOfNotANumber, DenseLook },
  };
}

std::vector<ExtremeScene> ExtremeShapes()
{
  return {
    { "StretchedAThousandTimes", Lumpy({ 11, 9, 2 }, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1000.0 }),
      [](MapperScene& scene)
      {
        SeenFrom({ { 12.0, 9.0, -8000.0 }, { 0.0, 0.0, 0.0 }, 0.1, { 1.0, 1e5 } })(scene);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1000.0);
      } },
    { "StretchedAndSeenFromTheSide", Lumpy({ 11, 9, 2 }, VTK_FLOAT, 0.0, 1.0, { 1.0, 1.0, 1000.0 }),
      [](MapperScene& scene) {
        SeenFrom({ { 30.0, 20.0, 300.0 }, { 0.0, 0.0, 200.0 }, 30.0, { 1.0, 1e5 } })(scene);
      } },
    { "ScaledBy1e-6", Lumpy(), Scaled(1e-6) },
    { "ScaledBy1e6", Lumpy(), Scaled(1e6) },
    { "SpacedBy1e-6", Lumpy(SmallBox, VTK_FLOAT, 0.0, 1.0, { 1e-6, 1e-6, 1e-6 }),
      UnitDistanceSeenObliquely(1e-6) },
    { "FarFromTheOrigin", Lumpy(),
      [](MapperScene& scene)
      {
        Look(scene);
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
    { "ClippedToNothingInFront", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 50.0, 100.0 } }) },
    { "ClippedToNothingBehind", Lumpy(),
      SeenFrom({ { -30.0, 3.0, 2.0 }, { 0.0, 0.0, 0.0 }, 30.0, { 1.0, 10.0 } }) },
    { "BehindTheCamera", Lumpy(), SeenFrom({ { -30.0, 3.0, 2.0 }, { -40.0, 0.0, 0.0 } }) },
  };
}

std::vector<ExtremeScene> ExtremesWithoutTolerance()
{
  return {
    { "OpaquePeakNarrowerThanATexel", Lumpy(SmallBox, VTK_UNSIGNED_SHORT, 0.0, 65535.0),
      [](MapperScene& scene)
      {
        Opacities({ { 30000.2, 0.0 }, { 30000.5, 0.9 }, { 30000.8, 0.0 } }, 0.0, 65535.0)(scene);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(1e-6);
      } },
    { "EightThousandSteps", Lumpy({ 2001, 3, 3 }),
      [](MapperScene& scene)
      {
        SampledEvery(0.25)(scene);
        SeenFrom({ { -1100.0, 12.0, 8.0 }, { 0.0, 0.0, 0.0 }, 0.15, { 1.0, 1e4 } })(scene);
        scene.volume->GetProperty()->SetScalarOpacityUnitDistance(300.0);
      } },
    { "StepLongerThanTheVolume", Lumpy(), SampledEvery(1e6) },
    { "StepOf1e-4Voxels", Lumpy({ 2, 2, 2 }), SampledEvery(1e-4) },
    { "StepOf1e-30", Lumpy({ 2, 2, 2 }), SampledEvery(1e-30) },
  };
}

std::vector<ExtremeScene> ExtremeScenes()
{
  std::vector<ExtremeScene> all;
  for (const auto& scenes : { ExtremeMaterials(), HardSurfaces(), ExtremeScalars(), ThinShapes(),
         ExtremeShapes(), ExtremeViews(), ExtremesWithoutTolerance() })
  {
    all.insert(all.end(), scenes.begin(), scenes.end());
  }
  return all;
}

std::unique_ptr<MapperScene> MapperSceneOf(
  const ExtremeScene& extreme, int size, vtkHeadlessRenderWindow* window)
{
  auto scene = std::make_unique<MapperScene>(extreme.image(), size, window);
  scene->mapper->SetErrorTolerance(1.0 / 64.0);
  extreme.prepare(*scene);
  return scene;
}
