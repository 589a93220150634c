// Functions of lanes against double precision, with the baseline's instructions.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace varimarch;

namespace
{

/// Compares a function of random lanes with the same function of each number.
void ExpectRelative(const std::function<Lanes(Lanes)>& function,
  const std::function<double(double)>& truth, float least, float most, double largestError)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(least, most);
  for (int i = 0; i < 20000; ++i)
  {
    const Numbers arguments(LanesOf([&](int) { return number(random); }));
    const Numbers results(function(LanesAt(arguments.of)));
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const double expected = truth(arguments.of[lane]);
      ASSERT_NEAR(results.of[lane], expected, largestError * std::abs(expected))
        << "of " << arguments.of[lane];
    }
  }
}

template <class Voxel>
void ExpectPairs()
{
  using Limits = std::numeric_limits<Voxel>;
  const Voxel voxels[] = { Limits::lowest(), Limits::max(), Voxel(1), Voxel(0), Voxel(-1), Voxel(7),
    Limits::max(), Limits::lowest(), Voxel(3) };
  const IntNumbers index(IntLanesOf([](int lane) { return (5 * lane + 2) % 8; }));
  const ValuePairs pairs = PairsAt(voxels, index);
  const Numbers first(pairs.first);
  const Numbers second(pairs.second);
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    EXPECT_EQ(first.of[lane], float(voxels[index.of[lane]]));
    EXPECT_EQ(second.of[lane], float(voxels[index.of[lane] + 1]));
  }
}

}

TEST(Lanes, RoundAsNumbersDo)
{
  const auto floor = [](double number) { return std::floor(number); };
  const auto floorOfLanes = [](Lanes number) { return Floor(number); };
  ExpectRelative(floorOfLanes, floor, -1000.0f, 1000.0f, 0.0);
  ExpectRelative(floorOfLanes, floor, -1e12f, 1e12f, 0.0); // beyond the range of int
  const auto nearest = [](double number) { return std::nearbyint(number); };
  ExpectRelative(Rounded, nearest, -1000.0f, 1000.0f, 0.0);
  const auto truncated = [](Lanes number) { return FloatOf(Truncated(number)); };
  ExpectRelative(
    truncated, [](double number) { return std::trunc(number); }, -1e6f, 1e6f, 0.0);
}

TEST(Lanes, HaveRootsPowersAndLogarithmsOfTheStatedErrors)
{
  const auto powerOfTwo = [](Lanes number)
  {
    const PowerOfTwo power(number);
    return power.whole + power.whole * power.partLessOne;
  };
  ExpectRelative(
    Sqrt, [](double number) { return std::sqrt(number); }, 1e-6f, 1e6f, 6e-8);
  ExpectRelative(
    InverseSqrt, [](double number) { return 1.0 / std::sqrt(number); }, 1e-6f, 1e6f, 3e-7);
  ExpectRelative(
    powerOfTwo, [](double number) { return std::exp2(number); }, -126.0f, 127.0f, 2e-7);
  ExpectRelative(
    SmallPowerOfTwo, [](double number) { return std::exp2(number); }, 0.0f, 2.0f, 6e-6);
  ExpectRelative(
    Log2, [](double number) { return std::log2(number); }, 2.0f, 1e30f, 3e-7);
}

TEST(Lanes, PowerIsThatOfNumbersForWholeAndOtherExponents)
{
  for (float exponent : { 1.0f, 8.0f, 21.0f, 0.3f, 7.5f })
  {
    ExpectRelative([=](Lanes base) { return Power(base, exponent); },
      [=](double base) { return std::pow(base, double(exponent)); }, 0.1f, 1.0f, 5e-6);
    EXPECT_EQ(Numbers(Power(Lanes{}, exponent)).of[0], 0.0f);
  }
}

TEST(Lanes, APowerOfZeroIsOne)
{
  EXPECT_EQ(Numbers(Power(All(0.3f), 0.0f)).of[0], 1.0f);
  EXPECT_EQ(Numbers(Power(All(0.3f), All(0.0f))).of[0], 1.0f);
}

TEST(ShaderMath, HasTheFormulasOfShadersInLanes)
{
  const auto absorption = [](double depth) { return -std::expm1(-depth); };
  ExpectRelative(Absorption, absorption, 1e-6f, 80.0f, 1e-6);
  for (const double factor : { 0.02, 0.5, 0.98 })
  {
    ExpectRelative([=](Lanes extinction)
      { return WithOpacityFactor(extinction, All(3.0f), All(float(factor))); },
      [=](double extinction) { return -std::log1p(-factor * absorption(3.0 * extinction)) / 3.0; },
      1e-4f, 10.0f, 1e-5);
  }
  const auto extinctionOf = [](Lanes opacity) { return ExtinctionOf(opacity, All(2.0f)); };
  ExpectRelative(
    extinctionOf, [](double opacity) { return -0.5 * std::log1p(-opacity); }, 1e-4f, 0.99f, 2e-6);
  EXPECT_EQ(Numbers(extinctionOf(All(1.0f))).of[0], 1e30f);
}

TEST(Lanes, TheSecondIsTakenWhereANumberIsNaN)
{
  const Lanes nan = All(std::numeric_limits<float>::quiet_NaN());
  const Lanes two = All(2.0f);
  EXPECT_EQ(Numbers(Min(nan, two)).of[0], 2.0f);
  EXPECT_EQ(Numbers(Max(nan, two)).of[0], 2.0f);
  EXPECT_TRUE(std::isnan(Numbers(Min(two, nan)).of[0]));
  EXPECT_TRUE(std::isnan(Numbers(Max(two, nan)).of[0]));
}

TEST(Lanes, AnyFindsEveryLane)
{
  EXPECT_FALSE(Any(LaneMask{}));
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const LaneMask one = IntLanesOf([&](int index) { return index == lane ? -1 : 0; });
    EXPECT_TRUE(Any(one));
    const Numbers chosen(Select(one, All(1.0f), All(-1.0f)));
    for (int other = 0; other < LaneCount; ++other)
    {
      EXPECT_EQ(chosen.of[other], other == lane ? 1.0f : -1.0f);
    }
  }
}

TEST(Lanes, AreTransposedNumberByNumber)
{
  float memory[LaneCount][4];
  Four numbers[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    for (int i = 0; i < 4; ++i)
    {
      memory[lane][i] = float(10 * lane + i);
    }
    numbers[lane] = FourAt(memory[lane]);
  }
  const Lanes4 columns = Transposed(numbers);
  const Numbers read[] = { Numbers(columns.x), Numbers(columns.y), Numbers(columns.z),
    Numbers(columns.w) };
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(read[i].of[lane], memory[lane][i]);
    }
  }
}

TEST(Lanes, ReadPairsOfVoxelsOfEveryType)
{
  ExpectPairs<std::int8_t>();
  ExpectPairs<std::uint8_t>();
  ExpectPairs<std::int16_t>();
  ExpectPairs<std::uint16_t>();
  ExpectPairs<float>();
}
