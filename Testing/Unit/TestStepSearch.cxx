#include "Core/Quality/StepSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace varimarch;

namespace
{

/// An image whose error is `factor` times the distance to the power of `order`, with a count of the
/// drawings.
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

/// A noisy image, whose errors at one distance are independent of those at another.
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

StepChoice Find(const SampleDrawing& draw, double first, const StepRange& range = Range)
{
  return FindSampleDistance(draw, Limit, range, first).choice;
}

}

TEST(StepSearch, TheErrorAtTheDistanceFoundIsNearTheLimit)
{
  int drawings = 0;
  for (double order : { 1.3, 2.0 })
  {
    for (double factor : { 0.001, 0.03, 0.5 })
    {
      const StepChoice choice = Find(PowerLaw{ factor, order, &drawings }, 1.0);
      const double error = factor * std::pow(choice.sampleDistance, order);
      EXPECT_TRUE(choice.KeepsLimit());
      EXPECT_LE(error, 1.2 * Limit.percentile999) << factor << " " << order;
      EXPECT_TRUE(error > 0.7 * Limit.percentile999 || choice.sampleDistance == Range.coarsest);
      EXPECT_NEAR(choice.error, error, 0.3 * error);
    }
  }
}

// One distance tells no order; the error of light is supposed to fall by the first.
TEST(StepSearch, AnErrorIsEstimatedByTheSupposedOrder)
{
  int drawings = 0;
  StepRange range = Range;
  range.supposedOrder = 1.0;
  const PowerLaw law{ 0.005, range.supposedOrder, &drawings };
  EXPECT_NEAR(FirstThatKeeps({ 1.0 }, law, Limit, range, 1.0).error, 0.005, 0.0002);
}

TEST(StepSearch, ItNeedsThreeDrawingsWhereItBeginsNearTheResult)
{
  int drawings = 0;
  const PowerLaw law{ 0.01, 2.0, &drawings };
  const double found = Find(law, 1.0).sampleDistance;
  drawings = 0;
  Find(law, 0.99 * found);
  EXPECT_LE(drawings, 3);
}

TEST(StepSearch, ErrorsThatDoNotDependOnEachOtherAreNotCountedTwice)
{
  const double distance = Find(IndependentErrors, 1.0).sampleDistance;
  const std::vector<float> truth(4 * 10000, 0.5f);
  EXPECT_NEAR(DifferenceOfLimit(IndependentErrors(distance), truth, Limit), 0.9, 0.15);
}

TEST(StepSearch, AnUnreachableLimitIsReportedAndEndsAtTheFinestStep)
{
  int drawings = 0;
  const StepChoice choice = Find(PowerLaw{ 100.0, 1.0, &drawings }, 0.5);
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
  const StepChoice choice = Find(law, 1.0, range);
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_GE(choice.sampleDistance, range.finest);
  EXPECT_LT(choice.sampleDistance, 0.8);
}

TEST(StepSearch, AnImageThatIsExactAtAnyStepTakesTheCoarsest)
{
  int drawings = 0;
  const StepChoice choice = Find(PowerLaw{ 0.0, 1.0, &drawings }, 1.0);
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_DOUBLE_EQ(choice.sampleDistance, Range.coarsest);
}

TEST(StepSearch, OnlyWhatWasTriedAndKeepsTheLimitIsTaken)
{
  constexpr double Longest = 1.4; // beyond it, errors exceed what finer images predict
  const auto draw = [&](double distance)
  {
    const double error = distance < Longest ? 0.004 * distance * distance : 0.5;
    return std::vector<float>(4 * 100, float(0.25 + error));
  };
  const double found = Find(draw, 1.0).sampleDistance;
  EXPECT_LT(found, Longest);
  EXPECT_GT(found, 0.85 * Longest);
}

TEST(StepSearch, AnUnexpectedOrderStillKeepsTheLimit)
{
  const auto errorAt = [](double distance)
  { return distance < 0.3 ? 0.001 : (distance < 0.6 ? 0.0085 : 0.012 + 0.003 * distance); };
  const auto draw = [&](double distance)
  { return std::vector<float>(4 * 100, float(0.25 + errorAt(distance))); };
  const StepChoice choice = Find(draw, 1.0);
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_GT(choice.sampleDistance, 0.3);
  EXPECT_LE(errorAt(choice.sampleDistance), Limit.percentile999);
}

TEST(StepSearch, AKnownImageSavesAFinerOne)
{
  int drawings = 0;
  const PowerLaw law{ 0.03, 1.6, &drawings };
  const std::vector<float> exact(4 * 100, 0.25f);
  double finest = Range.coarsest;
  const auto draw = [&](double distance)
  {
    finest = std::min(finest, distance);
    return law(distance);
  };
  const StepChoice choice = FindSampleDistance(draw, Limit, Range, 0.1, exact).choice;
  EXPECT_EQ(finest, 0.1);
  EXPECT_LE(drawings, 4);
  EXPECT_NEAR(0.03 * std::pow(choice.sampleDistance, 1.6), 0.9 * Limit.percentile999, 0.001);
}

TEST(StepSearch, OneBadPixelCountsByTheLimitOfTheLargestError)
{
  const auto draw = [](double distance)
  {
    std::vector<float> picture(4 * 10000, 0.5f);
    picture[0] = float(0.5 + 0.1 * distance);
    return picture;
  };
  const StepChoice choice = Find(draw, 1.0);
  EXPECT_LE(0.1 * choice.sampleDistance, 1.4 * Limit.largest);
  EXPECT_GE(0.1 * choice.sampleDistance, 0.7 * Limit.largest);
}

TEST(StepSearch, ARuleWhoseStepsCostMoreIsBetterWhereTheyAreLongerByMore)
{
  const StepChoice other{ 1.0, 0.01, 1.0 };
  EXPECT_FALSE(IsBetter({ 2.4, 0.01, 1.0 }, 2.5, other));
  EXPECT_TRUE(IsBetter({ 2.6, 0.01, 1.0 }, 2.5, other));
}

TEST(StepSearch, ARuleIsBetterThanOneThatDoesNotKeepTheLimitIfItErrsLess)
{
  EXPECT_TRUE(IsBetter({ 0.5, 0.01, 1.0 }, 2.5, { 1.0, 0.02, 2.0 }));
  EXPECT_TRUE(IsBetter({ 0.5, 0.015, 1.5 }, 2.5, { 0.5, 0.02, 2.0 }));
  EXPECT_FALSE(IsBetter({ 0.5, 0.03, 3.0 }, 2.5, { 0.5, 0.02, 2.0 }));
}

TEST(StepSearch, TheFinestPictureIsAQuarterOfTheDistanceOrLess)
{
  int drawings = 0;
  const PowerLaw law{ 0.03, 1.6, &drawings };
  const FoundSteps found = FindSampleDistance(law, Limit, Range, 1.0);
  const std::vector<float> exact(found.finest.size(), 0.25f);
  EXPECT_LT(ErrorOfLimit(found.finest, exact, Limit), 0.13);
  EXPECT_NEAR(ErrorOfLimit(law(found.choice.sampleDistance), found.finest, Limit), 0.95, 0.15);
}

TEST(StepSearch, OneBadPixelIsAnErrorOfThePicture)
{
  std::vector<float> picture(4 * 10000, 0.5f);
  const std::vector<float> exact = picture;
  picture[0] = 0.6f;
  EXPECT_NEAR(ErrorOfLimit(picture, exact, Limit), 0.1 / Limit.largest, 1e-3);
  EXPECT_EQ(DifferenceOfLimit(picture, exact, Limit), 0.0);
}

TEST(StepSearch, ItNeedsTwoDrawingsWhereAnEarlierDistanceStillHolds)
{
  int drawings = 0;
  const PowerLaw law{ 0.01, 2.0, &drawings };
  const double first = FindSampleDistance(law, Limit, Range, 1.0).choice.sampleDistance;
  const double second = FindSampleDistanceFrom(first, law, Limit, Range, 1.0).choice.sampleDistance;
  drawings = 0;
  const StepChoice third = FindSampleDistanceFrom(second, law, Limit, Range, 1.0).choice;
  EXPECT_EQ(drawings, 2);
  EXPECT_EQ(third.sampleDistance, second);
  EXPECT_GT(second, 0.8 * first);
  EXPECT_TRUE(third.KeepsLimit());
}

TEST(StepSearch, AnEarlierDistanceIsNotTakenWhereTheErrorIsAnother)
{
  int drawings = 0;
  for (const double factor : { 0.0005, 0.003, 0.03, 0.5 })
  {
    const PowerLaw law{ factor, 2.0, &drawings };
    const StepChoice choice = FindSampleDistanceFrom(1.0, law, Limit, Range, 1.0).choice;
    const double error = factor * choice.sampleDistance * choice.sampleDistance;
    EXPECT_TRUE(choice.KeepsLimit());
    EXPECT_LE(error, 1.2 * Limit.percentile999) << factor;
    EXPECT_TRUE(error > 0.7 * Limit.percentile999 || choice.sampleDistance == Range.coarsest);
  }
}

// An opaque surface appears, at which the error falls more slowly than in the image before.
TEST(StepSearch, AnEarlierDistanceKeepsTheLimitWhereTheErrorFallsSlowly)
{
  int drawings = 0;
  for (const double factor : { 0.0105, 0.0115, 0.0125, 0.0135 })
  {
    const PowerLaw law{ factor, 1.0, &drawings };
    const StepChoice choice = FindSampleDistanceFrom(1.0, law, Limit, Range, 1.0).choice;
    EXPECT_LE(factor * choice.sampleDistance, 1.16 * Limit.percentile999) << factor;
  }
}

// Both images of a long distance miss the feature.
TEST(StepSearch, AnEarlierLongDistanceDoesNotHideAFeatureThatASearchSees)
{
  constexpr double SeenFrom = 0.5;
  const auto draw = [&](double distance)
  { return std::vector<float>(4 * 100, distance < SeenFrom ? 0.75f : 0.25f); };
  const StepChoice choice = FindSampleDistanceFrom(4.0, draw, Limit, Range, 1.0).choice;
  EXPECT_TRUE(choice.KeepsLimit());
  EXPECT_LT(choice.sampleDistance, SeenFrom);
}

TEST(StepSearch, ASearchOfHalfOctavesTakesTheLongestThatKeepsTheLimit)
{
  constexpr double HalfOctave = 1.4142135623730951;
  StepRange range = Range;
  range.isOfHalfOctaves = true;
  int drawings = 0;
  for (const double factor : { 0.003, 0.01, 0.1, 1.0 })
  {
    const PowerLaw law{ factor, 1.6, &drawings };
    const StepChoice choice = Find(law, 1.0, range);
    const double halves = 2.0 * std::log2(choice.sampleDistance);
    EXPECT_NEAR(halves, std::round(halves), 1e-6) << factor;
    EXPECT_TRUE(choice.KeepsLimit());
    const double longer = factor * std::pow(HalfOctave * choice.sampleDistance, 1.6);
    EXPECT_GT(longer, Limit.percentile999) << factor;
  }
}

TEST(StepSearch, ASearchOfHalfOctavesNeedsTwoPassesWhereEachDrawsTheDistancesAround)
{
  StepRange range = Range;
  range.isOfHalfOctaves = true;
  int drawings = 0;
  for (const double factor : { 0.0, 0.0003, 0.003, 0.01, 0.1, 1.0, 30.0 })
  {
    const PowerLaw law{ factor, 1.6, &drawings };
    std::map<long, std::vector<float>> drawn; // by distance
    int passes = 0;
    const auto numberOf = [](double distance) { return std::lround(1e6 * std::log2(distance)); };
    const auto draw = [&](double distance)
    {
      if (drawn.count(numberOf(distance)) == 0)
      {
        ++passes;
        for (const double one : DistancesDrawnWith(distance, range))
        {
          drawn[numberOf(one)] = law(one);
        }
      }
      return drawn[numberOf(distance)];
    };
    Find(draw, 1.0, range);
    EXPECT_LE(passes, 2) << factor;
  }
}
