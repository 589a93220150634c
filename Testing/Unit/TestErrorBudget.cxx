#include "Core/Quality/ErrorBudget.h"
#include "Core/Quality/InteractiveQuality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace varimarch
{

namespace
{

constexpr double NoEarlyTermination = 0.0;

// The error of a pixel after window and level when every part of the budget is used up.
double SumOfParts(const ErrorBudget& budget)
{
  const double beforeWindow =
    budget.volumeCount * budget.FieldError() + budget.EarlyTermination(NoEarlyTermination);
  return std::abs(budget.windowScale) * beforeWindow + budget.StepLimit().percentile999;
}

std::vector<ErrorBudget> ManyBudgets()
{
  std::vector<ErrorBudget> budgets;
  for (double windowScale : { 0.25, 1.0, 3.0, -20.0 })
  {
    for (bool isExtreme : { false, true })
    {
      for (bool isSampled : { false, true })
      {
        for (int volumeCount : { 1, 2, 5 })
        {
          budgets.push_back({ 0.01, windowScale, isExtreme, isSampled, volumeCount });
        }
      }
    }
  }
  return budgets;
}

}

TEST(ErrorBudget, ItsPartsAddUpToNoMoreThanTheTolerance)
{
  for (const ErrorBudget& budget : ManyBudgets())
  {
    EXPECT_LE(SumOfParts(budget), budget.tolerance)
      << "window " << budget.windowScale << ", extreme " << budget.isExtreme << ", sampled "
      << budget.isSampled << ", volumes " << budget.volumeCount;
  }
}

TEST(ErrorBudget, TheSlackOfTheEstimateTakesAtMostOnePercentMoreThanTheTolerance)
{
  for (const ErrorBudget& budget : ManyBudgets())
  {
    const double slack = (ErrorBudget::EstimateSlack - 1.0) * budget.StepLimit().percentile999;
    EXPECT_LE(SumOfParts(budget) + slack, 1.01 * budget.tolerance);
  }
}

TEST(ErrorBudget, AmbientOcclusionTakesFromTheSteps)
{
  ErrorBudget budget;
  budget.tolerance = 1.0 / 64.0;
  const double open = budget.StepLimit().percentile999;
  budget.isOccluded = true;
  constexpr double ErrorOfTheLattice = 0.01 / 4.0;
  EXPECT_GT(open - budget.StepLimit().percentile999, ErrorOfTheLattice);
}

TEST(ErrorBudget, LaterImagesKeepTheToleranceToo)
{
  for (const ErrorBudget& budget : ManyBudgets())
  {
    const ErrorBudget later = budget.WithStepFactor(ErrorBudget::LaterImages);
    EXPECT_LE(SumOfParts(later), SumOfParts(budget));
    EXPECT_DOUBLE_EQ(later.StepTolerance(), ErrorBudget::LaterImages * budget.StepTolerance());
  }
}

TEST(ErrorBudget, WhileMovingThePartsAddUpToTheToleranceTimesItsFactor)
{
  InteractiveQuality quality;
  quality.Next(1e-3, 1e6);
  for (int image = 0; image < 20; ++image)
  {
    quality.Took(1.0); // always too late, so that the quality becomes the coarsest
    const double factor = quality.Next(1e-3, 1e6).toleranceFactor;
    EXPECT_LE(factor, ErrorBudget::MostWhileMoving);
    for (const ErrorBudget& budget : ManyBudgets())
    {
      EXPECT_LE(SumOfParts(budget.WithStepFactor(factor)), factor * budget.tolerance);
    }
  }
}

TEST(ErrorBudget, TheFieldStaysAsItIsWhenStepsMayErrMore)
{
  const ErrorBudget budget{ 0.02 };
  EXPECT_EQ(budget.WithStepFactor(4.0).FieldError(), budget.FieldError());
}

TEST(ErrorBudget, WithoutAToleranceExtremesAreExactAndOthersOffByOneLevelOfEightBits)
{
  ErrorBudget budget;
  EXPECT_DOUBLE_EQ(budget.FieldError(), 1.0 / 255.0);
  EXPECT_EQ(budget.EarlyTermination(0.125), 0.125);
  EXPECT_EQ(budget.StepTolerance(), 0.0);
  budget.isExtreme = true;
  EXPECT_EQ(budget.FieldError(), 0.0);
}

}
