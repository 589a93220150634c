#include "Core/StepSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace varimarch;

namespace
{

/// A picture whose error is `factor` times the distance to the power of `order`, and how often it
/// was drawn.
struct PowerLaw
{
  double factor;
  double order;
  int* drawings;

  std::vector<float> operator()(double distance) const
  {
    ++*this->drawings;
    const double error = this->factor * std::pow(distance, this->order);
    return std::vector<float>(4 * 100, float(0.25 + error));
  }
};

/// A picture of noise: what its pixels are off by at one distance tells nothing of another.
std::vector<float> IndependentErrors(double distance)
{
  std::mt19937 generator(unsigned(std::lround(1e6 * distance)));
  std::normal_distribution<double> error(0.0, 0.003 * std::pow(distance, 1.5));
  std::vector<float> picture(4 * 10000);
  std::generate(picture.begin(), picture.end(), [&] { return float(0.5 + error(generator)); });
  return picture;
}

constexpr ErrorLimit Limit{ 0.01, 0.02 };
constexpr StepRange Range{ 4.0, 1.0 / 32.0 };

}

TEST(StepSearch, TheErrorAtTheDistanceFoundIsNearTheLimit)
{
  int drawings = 0;
  for (double order : { 1.3, 2.0 })
  {
    for (double factor : { 0.001, 0.03, 0.5 })
    {
      const StepChoice choice =
        FindSampleDistance(PowerLaw{ factor, order, &drawings }, Limit, Range, 1.0);
      const double error = factor * std::pow(choice.sampleDistance, order);
      EXPECT_TRUE(choice.KeepsLimit());
      EXPECT_LE(error, 1.2 * Limit.percentile999) << factor << " " << order;
      EXPECT_TRUE(error > 0.7 * Limit.percentile999 || choice.sampleDistance == Range.coarsest);
      EXPECT_NEAR(choice.error, error, 0.3 * error);
    }
  }
}

TEST(StepSearch, ItNeedsFiveDrawingsWhereItBeginsNearTheResult)
{
  int drawings = 0;
  const PowerLaw law{ 0.01, 2.0, &drawings };
  const double found = FindSampleDistance(law, Limit, Range, 1.0).sampleDistance;
  drawings = 0;
  FindSampleDistance(law, Limit, Range, 0.99 * found);
  EXPECT_LE(drawings, 5);
}

TEST(StepSearch, ErrorsThatDoNotDependOnEachOtherAreNotCountedTwice)
{
  const double distance = FindSampleDistance(IndependentErrors, Limit, Range, 1.0).sampleDistance;
  const std::vector<float> truth(4 * 10000, 0.5f);
  EXPECT_NEAR(DifferenceOfLimit(IndependentErrors(distance), truth, Limit), 0.9, 0.15);
}

TEST(StepSearch, WhatCannotBeKeptIsSaidAndEndsAtTheFinestStep)
{
  int drawings = 0;
  const StepChoice choice =
    FindSampleDistance(PowerLaw{ 100.0, 1.0, &drawings }, Limit, Range, 0.5);
  EXPECT_FALSE(choice.KeepsLimit());
  EXPECT_DOUBLE_EQ(choice.sampleDistance, Range.finest);
  EXPECT_LE(drawings, 6);
}

TEST(StepSearch, TheFinestStepNeedNotBeAHalvingOfTheCoarsest)
{
  int drawings = 0;
  const StepRange range{ 4.0, 0.6 };
  const double atFinest = 0.8 * Limit.percentile999;
  const PowerLaw law{ atFinest / std::pow(range.finest, 2.0), 2.0, &drawings };
  const StepChoice choice = FindSampleDistance(law, Limit, range, 1.0);
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_GE(choice.sampleDistance, range.finest);
  EXPECT_LT(choice.sampleDistance, 0.8);
}

TEST(StepSearch, WhatIsExactAtAnyStepTakesTheCoarsest)
{
  int drawings = 0;
  const StepChoice choice = FindSampleDistance(PowerLaw{ 0.0, 1.0, &drawings }, Limit, Range, 1.0);
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_DOUBLE_EQ(choice.sampleDistance, Range.coarsest);
}

TEST(StepSearch, WhatErrsMuchBetweenTwoDistancesThatWereTriedIsNotTaken)
{
  const auto draw = [](double distance)
  {
    const bool isHalved = std::log2(distance) == std::round(std::log2(distance));
    const double error = isHalved ? 0.004 * distance * distance : 0.5;
    return std::vector<float>(4 * 100, float(0.25 + error));
  };
  EXPECT_EQ(FindSampleDistance(draw, Limit, Range, 1.0).sampleDistance, 1.0);
}

TEST(StepSearch, HalfOfTheWayIsTakenWhereAllOfItErrsMuch)
{
  const auto draw = [](double distance)
  {
    const bool isHalved = std::log2(distance) == std::round(std::log2(distance));
    const double error = isHalved || distance < 1.4 ? 0.004 * distance * distance : 0.5;
    return std::vector<float>(4 * 100, float(0.25 + error));
  };
  const double allOfIt = std::sqrt(Limit.percentile999 / 0.004);
  EXPECT_NEAR(FindSampleDistance(draw, Limit, Range, 1.0).sampleDistance, std::sqrt(allOfIt), 0.05);
}

TEST(StepSearch, WhereTheErrorHardlyFallsTheDistanceThatKeepsTheLimitIsTaken)
{
  const auto draw = [](double distance)
  {
    const double error = distance < 0.4 ? 0.0 : (distance < 0.8 ? 0.0085 : 0.0093);
    return std::vector<float>(4 * 100, float(0.25 + error));
  };
  EXPECT_EQ(FindSampleDistance(draw, Limit, Range, 1.0).sampleDistance, 0.5);
}

TEST(StepSearch, OneBadPixelCountsByTheLimitOfTheLargestError)
{
  const auto draw = [](double distance)
  {
    std::vector<float> picture(4 * 10000, 0.5f);
    picture[0] = float(0.5 + 0.1 * distance);
    return picture;
  };
  const StepChoice choice = FindSampleDistance(draw, Limit, Range, 1.0);
  EXPECT_LE(0.1 * choice.sampleDistance, 1.4 * Limit.largest);
  EXPECT_GE(0.1 * choice.sampleDistance, 0.7 * Limit.largest);
}

TEST(StepSearch, ARuleWhoseStepsCostMoreIsBetterWhereTheyAreLongerByMore)
{
  const StepChoice other{ 1.0, 0.01, 1.0 };
  EXPECT_FALSE(IsBetter({ 2.4, 0.01, 1.0 }, 2.5, other));
  EXPECT_TRUE(IsBetter({ 2.6, 0.01, 1.0 }, 2.5, other));
}

TEST(StepSearch, ARuleIsBetterThanOneThatDoesNotKeepTheLimit)
{
  EXPECT_TRUE(IsBetter({ 0.5, 0.01, 1.0 }, 2.5, { 1.0, 0.02, 2.0 }));
}
