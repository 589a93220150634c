// Steps of light that are longer than those of the image it lights.

#include "Core/Quality/ErrorBudget.h"
#include "Tolerance/ToleranceSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using varimarch::ErrorBudget;
using varimarch::SearchFacts;
using varimarch::ToleranceChoice;
using varimarch::ToleranceSearch;
using varimarch::TrialImage;

namespace
{

// The facts of a lit volume with voxels of 1 mm at a tolerance of 1/64.
SearchFacts FactsOfLitVolume()
{
  SearchFacts facts;
  facts.limit = { 0.66 / 64.0, 1.0 / 64.0 };
  facts.range = { 4.0, 1.0 / 128.0 };
  facts.firstMm = 1.0;
  facts.hasLight = true;
  facts.isShaded = true;
  facts.tracesLight = true;
  facts.lightOfLimit = 0.3;
  return facts;
}

// The choice for images of one grey, whose error has a part of the sample distance and one of the
// distance that light follows.
ToleranceChoice ChoiceWith(double errorPerMm2, double lightErrorPerMm)
{
  const auto draw = [&](const std::vector<TrialImage>& images)
  {
    std::vector<std::vector<float>> drawn;
    for (const TrialImage& image : images)
    {
      const double mm = image.sampleDistanceMm;
      const double ownMm = image.light.sampleDistanceMm;
      const double grey =
        0.5 + errorPerMm2 * mm * mm + lightErrorPerMm * (ownMm > 0.0 ? ownMm : mm);
      drawn.emplace_back(4 * 64, float(grey));
    }
    return drawn;
  };
  return ToleranceSearch::ChooseAnew(FactsOfLitVolume(), draw);
}

}

TEST(LightSteps, AreLongerThanThoseOfTheImageWhereLightIsSmooth)
{
  const ToleranceChoice choice = ChoiceWith(0.02, 1e-4);
  EXPECT_LT(choice.step.sampleDistance, 1.0);
  EXPECT_GT(choice.light.sampleDistanceMm, 3.0 * choice.step.sampleDistance);
  EXPECT_LE(choice.light.sampleDistanceMm, 4.0) << "longer than any step may be";
}

TEST(LightSteps, FollowTheImageWhereLightNeedsThem)
{
  const ToleranceChoice choice = ChoiceWith(1e-6, 0.02);
  EXPECT_EQ(choice.light.sampleDistanceMm, 0.0);
  EXPECT_LE(0.02 * choice.step.sampleDistance, 1.0 / 64.0);
}

// The error is that of the steps and that of the light, which the estimate adds up.
TEST(LightSteps, AddTheirErrorToTheEstimate)
{
  for (const double lightErrorPerMm : { 1e-4, 3e-4, 1e-3, 3e-3, 1e-2 })
  {
    const ToleranceChoice choice = ChoiceWith(0.02, lightErrorPerMm);
    const double mm = choice.step.sampleDistance;
    const double error =
      0.02 * mm * mm + lightErrorPerMm * std::max(mm, choice.light.sampleDistanceMm);
    EXPECT_LE(error, ErrorBudget::EstimateSlack * choice.step.error) << lightErrorPerMm;
    EXPECT_LE(choice.step.error, 1.0 / 64.0) << lightErrorPerMm;
  }
}
