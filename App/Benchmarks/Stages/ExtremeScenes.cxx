#include "Stages/ExtremeSceneParts.h"

#include <cmath>
#include <limits>

namespace varimarch
{

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

}
