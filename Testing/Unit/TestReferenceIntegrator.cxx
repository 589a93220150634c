#include "Unit/ReferenceVolumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace varimarch;

namespace
{

/// Nodes at random values, with kinks, steps and curves of all shapes.
TransferFunction RandomTransferFunction(std::mt19937& random, bool steps = true)
{
  std::uniform_real_distribution<double> number(0.0, 1.0);
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  for (double value = 0.1; value < 1.0; value += 0.4 * number(random))
  {
    const NodeShape shape{ number(random), number(random) < 0.5 ? 0.0 : number(random) };
    const glm::dvec3 rgb(number(random), number(random), number(random));
    colors.push_back({ value, rgb, shape });
    opacities.push_back({ value, 0.9 * number(random), { number(random), 0.3 } });
    if (steps && number(random) < 0.3)
    {
      opacities.push_back({ value, 0.9 * number(random) });
    }
  }
  return { colors, opacities, 1.0 };
}

/// Midpoint rule with so many steps that it converges without further measures.
glm::dvec4 MarchedColor(const ReferenceVolume& volume, const TransferFunction& transferFunction,
  const Ray& ray, double mmPerParameter)
{
  const Interval inside = Intersection(ray, volume.BoxGrid());
  const int steps = 100000;
  const double step = (inside.exit - inside.enter) / steps;
  glm::dvec4 sum(0.0);
  for (int k = 0; k < steps; ++k)
  {
    const double value =
      volume.Grid().Value(ray.origin + (inside.enter + (k + 0.5) * step) * ray.direction);
    const double alpha = -std::expm1(-transferFunction.Extinction(value) * step * mmPerParameter);
    sum += (1.0 - sum.a) * alpha * glm::dvec4(transferFunction.Color(value), 1.0);
  }
  return sum;
}

}

TEST(Reference, ConstantSlabHasItsClosedForm)
{
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 5.0) };
  const glm::dvec3 orange(1.0, 0.5, 0.0);
  const ReferenceScene scene =
    SceneOf(volume, { { { 5.0, orange } }, { { 0.0, 0.3 }, { 10.0, 0.3 } }, 2.0 });
  const double absorption = 1.0 - std::pow(0.7, 3.0 / 2.0);
  ExpectNear(ColorAlong(scene, alongX, 3.0), glm::dvec4(absorption * orange, absorption), 1e-14);
}

TEST(Reference, LengthIsMeasuredInTheWorldAndNotInTheParameter)
{
  const ReferenceVolume volume = RampAlongX(3);
  const ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.1 }, { 1.0, 0.8 } }, 1.0 });
  const Ray faster{ alongX.origin, 1000.0 * alongX.direction };
  ExpectNear(ColorAlong(scene, faster, 2000.0), ColorAlong(scene, alongX, 2.0), 1e-12);
}

TEST(Reference, OpacityRampHasItsClosedForm)
{
  // Opacity s / l over length l: the depth is l ((1 - x) ln(1 - x) + x), with x the last opacity.
  // It is finite even if the opacity reaches 1, where the extinction has a pole.
  for (const double last : { 0.01, 0.5, 0.99, 1.0 })
  {
    const ReferenceVolume volume = RampAlongX(4);
    const ReferenceScene scene =
      SceneOf(volume, { { { 0.0, red } }, { { 0.0, 0.0 }, { 1.0, last } }, 1.0 });
    const double remaining = last < 1.0 ? (1.0 - last) * std::log1p(-last) : 0.0;
    const double alpha = -std::expm1(-4.0 * (remaining + last) / last);
    ExpectNear(ColorAlong(scene, alongX), glm::dvec4(alpha, 0.0, 0.0, alpha));
  }
}

TEST(Reference, LinearColorInAConstantMediumHasItsClosedForm)
{
  const ReferenceVolume volume = RampAlongX(5);
  const ReferenceScene scene =
    SceneOf(volume, { { { 0.0, glm::dvec3(0.0) }, { 1.0, red } }, { { 0.0, 0.6 } }, 1.0 });
  const double depth = -5.0 * std::log1p(-0.6);
  const double transmittance = std::exp(-depth);
  ExpectNear(ColorAlong(scene, alongX),
    { (1.0 - (1.0 + depth) * transmittance) / depth, 0.0, 0.0, 1.0 - transmittance });
}

TEST(Reference, ExponentialColorByPlaceHasItsClosedForm)
{
  const ReferenceVolume volume = RampAlongX(3);
  ReferenceScene scene = SceneOf(volume, { { { 0.0, red } }, { { 0.0, 0.4 } }, 1.0 });
  const double decay = 0.7;
  scene.shade = LightByPlace([=](glm::dvec3 rgb, glm::dvec3 positionGrid, glm::dvec3)
    { return rgb * std::exp(-decay * positionGrid.x); });
  const double extinction = -std::log1p(-0.4);
  const double together = extinction + decay;
  ExpectNear(ColorAlong(scene, alongX),
    { -extinction / together * std::expm1(-3.0 * together), 0.0, 0.0, 1.0 - std::pow(0.6, 3.0) });
}

TEST(Reference, InterfaceIsExactAtAnyOffsetFromTheGrid)
{
  const ReferenceVolume volume = RampAlongX(7);
  for (const double value : { 1e-12, 0.1234, 1.0 / 7.0, 0.5, 0.987654321, 1.0 - 1e-12 })
  {
    const ReferenceScene scene = SceneOf(
      volume, { { { value, red }, { value, blue } }, { { value, 0.2 }, { value, 0.6 } }, 1.0 });
    const double front = 1.0 - std::pow(0.8, 7.0 * value);
    const double behind = (1.0 - front) * (1.0 - std::pow(0.4, 7.0 * (1.0 - value)));
    ExpectNear(ColorAlong(scene, alongX), { front, 0.0, behind, front + behind }, 1e-12);
    const Ray back{ { 9.0, 0.3, 0.6 }, { -1.0, 0.0, 0.0 } };
    EXPECT_NEAR(ColorAlong(scene, back).a, front + behind, 1e-12);
  }
}

TEST(Reference, OpaqueWallShowsThroughAThinVeil)
{
  const ReferenceVolume volume = RampAlongX(3);
  const double veil = 1e-3;
  const ReferenceScene scene = SceneOf(volume,
    { { { 0.5, red }, { 0.5, blue } }, { { 0.0, veil }, { 0.5, veil }, { 0.5, 1.0 } }, 1.0 });
  const double through = std::pow(1.0 - veil, 1.5);
  ExpectNear(ColorAlong(scene, alongX), { 1.0 - through, 0.0, through, 1.0 }, 1e-12);
}

TEST(Reference, OpaqueWallHasTheColorOfItsSurface)
{
  const ReferenceVolume volume = RampAlongX(3);
  const ReferenceScene scene =
    SceneOf(volume, { { { 0.0, red }, { 1.0, blue } }, { { 0.25, 0.0 }, { 0.25, 1.0 } }, 1.0 });
  ExpectNear(ColorAlong(scene, alongX), { 0.75, 0.0, 0.25, 1.0 }, 1e-12);
}

TEST(Reference, ConstantOpaqueVolumeIsASurface)
{
  // The opacity is 1 only at the node itself, which is the value of all voxels.
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 1.0) };
  const ReferenceScene scene =
    SceneOf(volume, { { { 1.0, red } }, { { 0.0, 0.0 }, { 1.0, 1.0 }, { 2.0, 0.0 } }, 1.0 });
  ExpectNear(ColorAlong(scene, alongX, 1e-9), { 1.0, 0.0, 0.0, 1.0 }, 0.0);
}

TEST(Reference, PeakOfAMillionthIsNotMissed)
{
  const ReferenceVolume volume = RampAlongX(3);
  const double half = 0.5e-6, opacity = 0.9, unitMm = 1e-6;
  const ReferenceScene scene =
    SceneOf(volume, { {}, { { 0.4 - half, 0.0 }, { 0.4, opacity }, { 0.4 + half, 0.0 } }, unitMm });
  const double depth =
    3.0 * 2.0 * half / unitMm * ((1.0 - opacity) * std::log1p(-opacity) + opacity) / opacity;
  EXPECT_NEAR(ColorAlong(scene, alongX).a, -std::expm1(-depth), 1e-8);
}

TEST(Reference, DenseRampIsASurface)
{
  // At optical depths of 1e12, only a millionth of the ray is visible.
  const ReferenceVolume volume = RampAlongX(2);
  for (const double unitMm : { 1e-3, 1e-6, 1e-12 })
  {
    const ReferenceScene scene = SceneOf(volume,
      { { { 0.5, red }, { 0.5 + 1e-4, red }, { 1.0, blue } }, { { 0.0, 0.0 }, { 0.9, 0.9 } },
        unitMm });
    const glm::dvec4 color = ColorAlong(scene, alongX);
    ExpectNear(color, { 1.0, 0.0, 0.0, 1.0 });
  }
}

TEST(Reference, ThinHazeKeepsItsRelativeAccuracy)
{
  const ReferenceVolume volume = RampAlongX(2);
  const ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 1e-12 }, { 1.0, 3e-12 } }, 1.0 });
  EXPECT_NEAR(ColorAlong(scene, alongX).r / 4e-12, 1.0, 1e-9);
}

TEST(Reference, InvisibleVolumeLeavesNothing)
{
  const ReferenceVolume volume = RampAlongX(2);
  const ReferenceScene scene =
    SceneOf(volume, { {}, { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 1.0 } }, 1.0 });
  EXPECT_EQ(ColorAlong(scene, alongX), glm::dvec4(0.0));
}

TEST(Reference, CuttingARayChangesNothing)
{
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 5, 4, 6 }, random);
    const ReferenceScene scene = SceneOf(volume, RandomTransferFunction(random));
    const Ray ray = RandomRay(volume.dimensions, random);
    const double cut = std::uniform_real_distribution<double>(0.7, 1.1)(random);
    const glm::dvec4 whole = ColorAlong(scene, ray, 2.0);
    const glm::dvec4 front = ColorAlong(scene, ray, 2.0, { 0.0, cut });
    const glm::dvec4 behind = ColorAlong(scene, ray, 2.0, { cut, infinity });
    ExpectNear(front + (1.0 - front.a) * behind, whole, 4e-9);
  }
}

TEST(Reference, AgreesWithAMarchOfTinySteps)
{
  std::mt19937 random(6);
  for (int i = 0; i < 20; ++i)
  {
    // The march misses an interface by up to a step, and is of second order without one.
    const bool interfaces = i % 2;
    const ReferenceVolume volume = RandomVolume({ 4, 3, 5 }, random);
    const TransferFunction transferFunction = RandomTransferFunction(random, interfaces);
    const Ray ray = RandomRay(volume.dimensions, random);
    ExpectNear(ColorAlong(SceneOf(volume, transferFunction), ray, 3.0),
      MarchedColor(volume, transferFunction, ray, 3.0), interfaces ? 3e-5 : 2e-9);
  }
}

TEST(Reference, KeepsTheToleranceAskedFor)
{
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 6, 6, 6 }, random);
    const ReferenceScene scene = SceneOf(volume, RandomTransferFunction(random));
    const Ray ray = RandomRay(volume.dimensions, random);
    const glm::dvec4 truth = ReferenceIntegrator(scene, 1e-12).Color(ray, 4.0).rgba;
    for (const double tolerance : { 1e-3, 1e-6, 1e-9 })
    {
      const ReferenceColor color = ReferenceIntegrator(scene, tolerance).Color(ray, 4.0);
      ExpectNear(color.rgba, truth, std::min(tolerance, color.error + 1e-13));
    }
  }
}

TEST(Reference, RayInAFaceOrAlongAnEdgeSeesTheVolume)
{
  const ReferenceVolume volume{ { 3, 3, 3 }, std::vector<double>(27, 1.0) };
  const ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 });
  for (const glm::dvec3 origin :
    { glm::dvec3(-1.0, 0.0, 0.0), { -1.0, 2.0, 2.0 }, { -1.0, 1.0, 0.5 }, { -1.0, 2.0, 1.0 } })
  {
    EXPECT_NEAR(ColorAlong(scene, { origin, { 1.0, 0.0, 0.0 } }).a, 0.75, 1e-14);
  }
  const double diagonalMm = std::sqrt(3.0);
  const Ray diagonal{ glm::dvec3(3.0), glm::dvec3(-1.0) };
  EXPECT_NEAR(
    ColorAlong(scene, diagonal, diagonalMm).a, 1.0 - std::pow(0.5, 2.0 * diagonalMm), 1e-14);
}

TEST(Reference, GridOneVoxelThickIsDrawnOneVoxelThick)
{
  const ReferenceVolume volume{ { 2, 1, 2 }, { 0.0, 1.0, 0.0, 1.0 } };
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.0 }, { 1.0, 0.8 } }, 1.0 });
  scene.boxGrid = { { 0.0, -0.5, 0.0 }, { 1.0, 0.5, 1.0 } };
  const Ray across{ { 0.25, 3.0, 0.5 }, { 0.0, -1.0, 0.0 } };
  EXPECT_NEAR(ColorAlong(scene, across).a, 0.2, 1e-14);
}

TEST(Reference, VoxelThatIsNotFiniteHidesOnlyItsCells)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity })
  {
    ReferenceVolume volume{ { 7, 2, 2 }, std::vector<double>(28, 1.0) };
    volume.voxels[3] = bad;
    ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 });
    EXPECT_NEAR(ColorAlong(scene, alongX).a, 1.0 - std::pow(0.5, 4.0), 1e-14);
    scene.blend = Blend::MaximumIntensity;
    EXPECT_NEAR(ColorAlong(scene, alongX).a, 0.5, 1e-14);
  }
}

TEST(Reference, CellsThatAreNotFiniteAreOfTheMaterialOfGaps)
{
  ReferenceVolume volume{ { 7, 2, 2 }, std::vector<double>(28, 1.0) };
  volume.voxels[3] = std::numeric_limits<double>::quiet_NaN();
  ReferenceScene scene = SceneOf(volume, { { { 0.0, blue } }, { { 0.0, 0.5 } }, 1.0 });
  scene.gap = { red, 0.3 };
  const double before = 1.0 - 0.25;
  const double gap = 0.25 * (1.0 - std::exp(-0.6));
  const double behind = 0.25 * std::exp(-0.6) * (1.0 - 0.25);
  ExpectNear(ColorAlong(scene, alongX), { gap, 0.0, before + behind, before + gap + behind });
}

TEST(Reference, MaximumInsideACellIsFound)
{
  // Along the diagonal of a cell, x y (1 - z) is u^2 (1 - u), at most 4 / 27.
  ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 0.0) };
  volume.voxels[3] = 1.0;
  ReferenceScene scene = SceneOf(volume, { { { 0.0, red } }, { { 0.0, 0.0 }, { 1.0, 1.0 } }, 1.0 });
  scene.blend = Blend::MaximumIntensity;
  const Ray diagonal{ glm::dvec3(-1.0), glm::dvec3(1.0) };
  ExpectNear(ColorAlong(scene, diagonal), { 4.0 / 27.0, 0.0, 0.0, 4.0 / 27.0 }, 1e-15);
}

TEST(Reference, RayThatMissesIsClear)
{
  const ReferenceVolume volume = RampAlongX(2);
  for (const Blend blend : { Blend::Composite, Blend::MaximumIntensity })
  {
    ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 });
    scene.blend = blend;
    EXPECT_EQ(ColorAlong(scene, { { 0.0, 5.0, 0.0 }, { 1.0, 0.0, 0.0 } }), glm::dvec4(0.0));
  }
}

TEST(Reference, UnusableSettingsAreRefused)
{
  const ReferenceVolume volume = RampAlongX(2);
  const TransferFunction nothing({}, {}, 1.0);
  EXPECT_THROW(ReferenceIntegrator(SceneOf(volume, nothing), 0.0), std::invalid_argument);
  EXPECT_THROW(
    ReferenceIntegrator(ReferenceScene{ {}, volume.BoxGrid(), nothing }), std::invalid_argument);
}

TEST(Reference, OpacityThatRoundsToOneIsASurface)
{
  // All values lie within a few bits of the node where the curve reaches 1.
  ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 3.0) };
  volume.voxels[0] = std::nextafter(3.0, 0.0);
  const ReferenceScene scene =
    SceneOf(volume, { { { 0.0, red } }, { { 0.0, 0.0 }, { 3.0, 1.0 }, { 4.0, 0.0 } }, 1e-3 });
  ExpectNear(ColorAlong(scene, alongX), { 1.0, 0.0, 0.0, 1.0 });
}
