// Minimum, average, additive and isosurface of the reference.

#include "Unit/ReferenceVolumes.h"

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

ReferenceScene SceneOf(
  const ReferenceVolume& volume, TransferFunction transferFunction, Blend blend)
{
  ReferenceScene scene = SceneOf(volume, std::move(transferFunction));
  scene.blend = blend;
  return scene;
}

/// A transfer function whose opacity equals the value.
TransferFunction Proportional(double unitDistanceMm = 1.0)
{
  return { {}, { { 0.0, 0.0 }, { 1.0, 1.0 } }, unitDistanceMm };
}

/// Values at the midpoints of many equal steps along a ray.
std::vector<double> ValuesAlong(const ReferenceVolume& volume, const Ray& ray, int steps)
{
  const Interval inside = Intersection(ray, volume.BoxGrid());
  std::vector<double> values;
  for (int k = 0; k < steps; ++k)
  {
    const double t = inside.enter + (k + 0.5) / steps * (inside.exit - inside.enter);
    values.push_back(volume.Grid().Value(ray.origin + t * ray.direction));
  }
  return values;
}

void ExpectWhite(glm::dvec4 color, double intensity, double tolerance = 1e-12)
{
  ExpectNear(color, { intensity, intensity, intensity, 1.0 }, tolerance);
}

}

TEST(ReferenceMinimum, InsideACellIsFound)
{
  // Along the diagonal of a cell, 1 - x y (1 - z) is 1 - u^2 (1 - u), at least 23 / 27.
  ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 1.0) };
  volume.voxels[3] = 0.0;
  const ReferenceScene scene = SceneOf(
    volume, { { { 0.0, red } }, { { 0.0, 0.0 }, { 1.0, 1.0 } }, 1.0 }, Blend::MinimumIntensity);
  const Ray diagonal{ glm::dvec3(-1.0), glm::dvec3(1.0) };
  ExpectNear(ColorAlong(scene, diagonal), { 23.0 / 27.0, 0.0, 0.0, 23.0 / 27.0 }, 1e-15);
}

TEST(ReferenceMinimum, IsTheMaximumOfTheMirroredValues)
{
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 5, 4, 6 }, random);
    ReferenceVolume mirrored = volume;
    for (double& voxel : mirrored.voxels)
    {
      voxel = 1.0 - voxel;
    }
    const Ray ray = RandomRay(volume.dimensions, random);
    const double smallest =
      ColorAlong(SceneOf(volume, Proportional(), Blend::MinimumIntensity), ray).a;
    const double largest =
      ColorAlong(SceneOf(mirrored, Proportional(), Blend::MaximumIntensity), ray).a;
    EXPECT_NEAR(
      smallest, Intersection(ray, volume.BoxGrid()).IsEmpty() ? 0.0 : 1.0 - largest, 1e-14);
  }
}

TEST(ReferenceAverage, RampHasItsClosedForm)
{
  // Opacity and grey are both x: the mean of x^2 over [p, q] is (q^3 - p^3) / (3 (q - p)).
  const ReferenceVolume volume = RampAlongX(7);
  ReferenceScene scene = SceneOf(volume, Proportional(), Blend::AverageIntensity);
  ExpectWhite(ColorAlong(scene, alongX), 1.0 / 3.0);
  const double p = 0.123, q = 0.789;
  scene.averagedRange = { p, q };
  ExpectWhite(ColorAlong(scene, alongX), (q * q * q - p * p * p) / (3.0 * (q - p)));
}

TEST(ReferenceAverage, DoesNotDependOnLengthOrUnitDistance)
{
  const ReferenceVolume volume = RampAlongX(3);
  const ReferenceScene scene = SceneOf(volume, Proportional(7.0), Blend::AverageIntensity);
  ExpectWhite(ColorAlong(scene, alongX, 1000.0), 1.0 / 3.0);
}

TEST(ReferenceAverage, GrayRangeSaysWhatIsBlackAndWhite)
{
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 30.0) };
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 }, Blend::AverageIntensity);
  scene.grayRange = { 10.0, 50.0 };
  ExpectWhite(ColorAlong(scene, alongX), 0.25);
  scene.grayRange = { 30.0, 30.0 };
  ExpectWhite(ColorAlong(scene, alongX), 0.0);
}

TEST(ReferenceAverage, RangeHoldsItsEndsAndNothingElse)
{
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 0.5) };
  ReferenceScene scene = SceneOf(volume, Proportional(), Blend::AverageIntensity);
  for (const ValueRange range : { ValueRange{ 0.5, 0.5 }, { 0.5, 0.9 }, { 0.1, 0.5 } })
  {
    scene.averagedRange = range;
    ExpectWhite(ColorAlong(scene, alongX), 0.25);
  }
  scene.averagedRange = { std::nextafter(0.5, 1.0), 1.0 };
  EXPECT_EQ(ColorAlong(scene, alongX), glm::dvec4(0.0)) << "nothing to average";
}

TEST(ReferenceAverage, AgreesWithTheMeanOfManySamples)
{
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 4, 3, 5 }, random);
    // The function has a kink, a step and a curved segment.
    const TransferFunction transferFunction(
      {}, { { 0.1, 0.0 }, { 0.4, 0.7, { 0.3, 0.5 } }, { 0.6, 0.2 }, { 0.6, 1.0 } }, 2.0);
    ReferenceScene scene = SceneOf(volume, transferFunction, Blend::AverageIntensity);
    scene.averagedRange = { 0.25, 0.75 };
    const Ray ray = RandomRay(volume.dimensions, random);
    double sum = 0.0;
    int count = 0;
    for (const double value : ValuesAlong(volume, ray, 100000))
    {
      const bool counts = 0.25 <= value && value <= 0.75;
      sum += counts ? value * transferFunction.Opacity(value) : 0.0;
      count += counts;
    }
    EXPECT_NEAR(ColorAlong(scene, ray).r, count > 0 ? sum / count : 0.0, 1e-4);
  }
}

TEST(ReferenceAdditive, RampHasItsClosedForm)
{
  // The integral of x^2 over a length l is l / 3, in unit distances.
  const ReferenceVolume volume = RampAlongX(6);
  const ReferenceScene scene = SceneOf(volume, Proportional(5.0), Blend::Additive);
  ExpectWhite(ColorAlong(scene, alongX, 0.5), 3.0 / 3.0 / 5.0);
}

TEST(ReferenceAdditive, IsWhiteAtMost)
{
  const ReferenceVolume volume = RampAlongX(6);
  ExpectWhite(ColorAlong(SceneOf(volume, Proportional(), Blend::Additive), alongX), 1.0);
}

TEST(ReferenceAdditive, PartsOfARayAddUp)
{
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 5, 4, 6 }, random);
    const ReferenceScene scene = SceneOf(volume, Proportional(100.0), Blend::Additive);
    const Ray ray = RandomRay(volume.dimensions, random);
    const double front = ColorAlong(scene, ray, 1.0, { 0.0, 0.9 }).r;
    const double behind = ColorAlong(scene, ray, 1.0, { 0.9, infinity }).r;
    EXPECT_NEAR(ColorAlong(scene, ray).r, front + behind, 1e-9);
  }
}

TEST(ReferenceIsosurface, SurfacesAreBlendedFrontToBack)
{
  const ReferenceVolume volume = RampAlongX(3);
  ReferenceScene scene = SceneOf(volume,
    { { { 0.5, red }, { 0.5, blue } }, { { 0.5, 0.3 }, { 0.5, 0.6 } }, 1.0 }, Blend::Isosurface);
  scene.isovalues = { 0.9, 0.2 };
  ExpectNear(ColorAlong(scene, alongX), { 0.3, 0.0, 0.7 * 0.6, 1.0 - 0.7 * 0.4 }, 1e-15);
  const Ray back{ { 9.0, 0.3, 0.6 }, { -1.0, 0.0, 0.0 } };
  ExpectNear(ColorAlong(scene, back), { 0.4 * 0.3, 0.0, 0.6, 1.0 - 0.7 * 0.4 }, 1e-15);
}

TEST(ReferenceIsosurface, LiesAtTheRootAndIsLitThere)
{
  // Along the diagonal of a cell, x y z is u^3.
  ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 0.0) };
  volume.voxels[7] = 1.0;
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 1.0 } }, 1.0 }, Blend::Isosurface);
  scene.isovalues = { 0.3 };
  scene.shade =
    LightByPlace([](glm::dvec3, glm::dvec3 positionGrid, glm::dvec3) { return positionGrid; });
  const Ray diagonal{ glm::dvec3(-2.0), glm::dvec3(1.0) };
  ExpectNear(ColorAlong(scene, diagonal), glm::dvec4(glm::dvec3(std::cbrt(0.3)), 1.0), 1e-14);
}

TEST(ReferenceIsosurface, IsPassedAsOftenAsTheValueChangesSides)
{
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 6, 5, 7 }, random);
    ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.1 } }, 1.0 }, Blend::Isosurface);
    scene.isovalues = { 0.5 };
    const Ray ray = RandomRay(volume.dimensions, random);
    const std::vector<double> values = ValuesAlong(volume, ray, 20000);
    int changes = 0;
    for (std::size_t k = 1; k < values.size(); ++k)
    {
      changes += (values[k] < 0.5) != (values[k - 1] < 0.5);
    }
    EXPECT_NEAR(ColorAlong(scene, ray).a, 1.0 - std::pow(0.9, changes), 1e-12);
  }
}

TEST(ReferenceIsosurface, InTheFacesOfCellsIsPassedOnce)
{
  // Rounding must neither lose a surface between two cells nor count it in both.
  const int cells = 7;
  const ReferenceVolume volume = RampAlongX(cells);
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.1 } }, 1.0 }, Blend::Isosurface);
  for (int plane = 1; plane < cells; ++plane)
  {
    scene.isovalues.push_back(double(plane) / cells);
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 start(-0.1, number(random), number(random));
    const glm::dvec3 end(cells + 0.1, number(random), number(random));
    const double alpha = 1.0 - std::pow(0.9, cells - 1);
    EXPECT_NEAR(ColorAlong(scene, { start, end - start }).a, alpha, 1e-12);
    EXPECT_NEAR(ColorAlong(scene, { end, start - end }).a, alpha, 1e-12);
  }
}

TEST(ReferenceIsosurface, BoundsAPlateauOfItsOwnValueAndNotTheVolume)
{
  ReferenceVolume volume = RampAlongX(4);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
  {
    volume.voxels[i] = i % 5 == 1 || i % 5 == 2 || i % 5 == 4 ? 1.0 : 0.0;
  }
  // Values 0 1 1 0 1: into the plateau, out of it, and up to the volume's face.
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 }, Blend::Isosurface);
  scene.isovalues = { 1.0 };
  EXPECT_NEAR(ColorAlong(scene, alongX).a, 1.0 - std::pow(0.5, 3.0), 1e-15);
  scene.isovalues = { 0.0 };
  EXPECT_EQ(ColorAlong(scene, alongX).a, 0.0) << "all values are at least 0";
}

TEST(ReferenceIsosurface, NoSurfaceBoundsWhatIsNotFinite)
{
  ReferenceVolume volume{ { 7, 2, 2 }, std::vector<double>(28, 1.0) };
  volume.voxels[3] = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 28; ++i)
  {
    volume.voxels[i] = i % 7 < 3 ? 0.0 : volume.voxels[i];
  }
  // The values are 0 on one side of the gap and 1 on the other.
  ReferenceScene scene = SceneOf(volume, { {}, { { 0.0, 0.5 } }, 1.0 }, Blend::Isosurface);
  scene.isovalues = { 0.5, infinity, std::numeric_limits<double>::quiet_NaN() };
  EXPECT_EQ(ColorAlong(scene, alongX).a, 0.0);
}

TEST(ReferenceBlends, RayThatMissesOrMeetsNothingFiniteIsClear)
{
  const ReferenceVolume nothing{ { 2, 2, 2 },
    std::vector<double>(8, std::numeric_limits<double>::quiet_NaN()) };
  for (const Blend blend : { Blend::Composite, Blend::MaximumIntensity, Blend::MinimumIntensity,
         Blend::AverageIntensity, Blend::Additive, Blend::Isosurface })
  {
    ReferenceScene scene = SceneOf(nothing, { {}, { { 0.0, 0.5 } }, 1.0 }, blend);
    EXPECT_EQ(ColorAlong(scene, alongX), glm::dvec4(0.0));
    EXPECT_EQ(ColorAlong(scene, { { 0.0, 5.0, 0.0 }, { 1.0, 0.0, 0.0 } }), glm::dvec4(0.0));
  }
}
