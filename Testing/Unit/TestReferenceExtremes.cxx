// The reference integrator at the limits of floating-point numbers, against closed forms.

#include "Unit/ReferenceVolumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace varimarch;

namespace
{

const double OneUlpBelowOne = std::nextafter(1.0, 0.0);
constexpr double SmallestNumber = std::numeric_limits<double>::denorm_min();
const glm::dvec3 orange(1.0, 0.5, 0.25);

/// Requires relative accuracy, so that a number of 1e-12 is right in its digits.
void ExpectSame(const glm::dvec4& color, const glm::dvec4& truth)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    // Alpha is 1 - T, so only digits of T above the machine epsilon remain.
    const double lost = channel == 3 ? std::numeric_limits<double>::epsilon() : 0.0;
    EXPECT_NEAR(color[channel], truth[channel], 1e-12 * std::abs(truth[channel]) + lost)
      << "channel " << channel;
  }
}

glm::dvec4 Homogeneous(double opticalDepth)
{
  const double absorption = -std::expm1(-opticalDepth);
  return glm::dvec4(absorption * orange, absorption);
}

}

TEST(ReferenceExtremes, ASlabOfAnyDepthHasItsClosedForm)
{
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 5.0) };
  for (double depth = 1e-12; depth < 2e12; depth *= 10.0)
  {
    // The same depth as a thin material over a long distance, and as a dense one over a short
    // distance.
    for (const double lengthMm : { 1e-6, 1.0, 1e6 })
    {
      SCOPED_TRACE(depth);
      const double unitDistanceMm = lengthMm * std::log(2.0) / depth;
      const ReferenceScene scene =
        SceneOf(volume, { { { 5.0, orange } }, { { 5.0, 0.5 } }, unitDistanceMm });
      ExpectSame(ColorAlong(scene, alongX, lengthMm), Homogeneous(depth));
    }
  }
}

TEST(ReferenceExtremes, OpacitiesOneUlpFromTheirEndsHaveTheirClosedForm)
{
  const ReferenceVolume volume{ { 2, 2, 2 }, std::vector<double>(8, 5.0) };
  const auto drawn = [&](double opacity, double lengthMm)
  {
    return ColorAlong(
      SceneOf(volume, { { { 5.0, orange } }, { { 5.0, opacity } }, 1.0 }), alongX, lengthMm);
  };
  // 1 - (1 - a) ^ length, with 1 - a = 2^-53 and a = 2^-52.
  ExpectSame(drawn(OneUlpBelowOne, 1e-3), Homogeneous(53e-3 * std::log(2.0)));
  ExpectSame(drawn(std::numeric_limits<double>::epsilon(), 1e3), Homogeneous(std::exp2(-52) * 1e3));
  ExpectSame(drawn(SmallestNumber, 1.0), Homogeneous(SmallestNumber));
  ExpectSame(drawn(1.0, 1e-12), glm::dvec4(orange, 1.0));
}

TEST(ReferenceExtremes, AStepIsWhereItsValueIsWhateverTheScaleOfTheValues)
{
  // Values from `first` to `first + range` along a cell. Beyond `place` the volume is opaque red,
  // behind a haze with an opacity of a millionth.
  const double place = 0.375;
  const double hazeDepth = -std::log1p(-1e-6) * place;
  for (const auto& [first, range] : { std::pair(0.0, 1.0), { 0.0, 1e-30 }, { -5e29, 1e30 },
         { 1e7, 1.0 }, { -1e7, 1e-6 }, { 0.0, 1e300 } })
  {
    SCOPED_TRACE(first);
    SCOPED_TRACE(range);
    ReferenceVolume volume = RampAlongX(1);
    for (double& voxel : volume.voxels)
    {
      voxel = first + range * voxel;
    }
    const double step = first + place * range;
    const ReferenceScene scene = SceneOf(volume,
      { { { step, blue }, { step, red } }, { { first, 1e-6 }, { step, 1e-6 }, { step, 1.0 } },
        1.0 });
    const double haze = -std::expm1(-hazeDepth);
    // A value of 1e7 + 1e-6 x has only eight digits of x, which shifts the step.
    const double digits =
      4.0 * std::numeric_limits<double>::epsilon() * (1.0 + std::abs(first) / range);
    ExpectNear(ColorAlong(scene, alongX), { 1.0 - haze, 0.0, haze, 1.0 }, 1e-12 + 1e-6 * digits);
  }
}

TEST(ReferenceExtremes, OpacitiesOfAMillionToOneHaveTheirClosedForm)
{
  // Two cells of haze with a nearly opaque one between them, each seen through those in front.
  const ReferenceVolume volume = RampAlongX(1);
  const ReferenceScene scene = SceneOf(volume,
    { { { 0.25, red }, { 0.25, blue }, { 0.5, blue }, { 0.5, red } },
      { { 0.25, 1e-6 }, { 0.25, 0.999999 }, { 0.5, 0.999999 }, { 0.5, 1e-6 } }, 0.25 });
  const double haze = 1e-6;
  const double wall = 0.999999;
  const double behind = (1.0 - haze) * (1.0 - wall) * -std::expm1(2.0 * std::log1p(-haze));
  const double middle = (1.0 - haze) * wall;
  const glm::dvec4 truth(haze + behind, 0.0, middle, haze + middle + behind);
  ExpectNear(ColorAlong(scene, alongX), truth, 1e-15);
}
