#include "Scene/Model/SceneChange.h"

#include "Core/Look/TransferFunction.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneCuts.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

TransferFunction CurvesOf(const Look& look)
{
  return { look.colors, look.opacities, look.opacityUnitDistanceMm };
}

// The largest difference of extinctions between two looks, beside steps.
double LargestDifference(const Look& a, const Look& b)
{
  double largest = 0.0;
  for (double value = -1000.25; value < 3000.0; value += 1.0)
  {
    largest =
      std::max(largest, std::abs(CurvesOf(a).Extinction(value) - CurvesOf(b).Extinction(value)));
  }
  return largest;
}

}

TEST(SceneChange, OfALookBeginsAndEndsWithTheLooks)
{
  const Look bone = BuiltInPreset("ct-bone").look;
  const Look skin = BuiltInPreset("ct-skin").look;
  ASSERT_TRUE(CanChange(bone, skin));
  EXPECT_LT(LargestDifference(LookBetween(bone, skin, 0.0), bone), 1e-9);
  EXPECT_LT(LargestDifference(LookBetween(bone, skin, 1.0), skin), 1e-9);
  EXPECT_EQ(LookBetween(bone, skin, 0.0).shading.diffuse, bone.shading.diffuse);
}

TEST(SceneChange, OfALookMixesOpacitiesAndTheColorsThatAreSeen)
{
  Look red;
  red.colors = { { 0.0, { 1.0, 0.0, 0.0 } } };
  red.opacities = { { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 0.75 }, { 20.0, 0.75 } };
  red.opacityUnitDistanceMm = 2.0;
  Look blue;
  blue.colors = { { 0.0, { 0.0, 0.0, 1.0 } } };
  blue.opacities = { { 0.0, 0.5 }, { 20.0, 0.5 } };
  const TransferFunction half = CurvesOf(LookBetween(red, blue, 0.5));
  EXPECT_NEAR(half.Opacity(5.0), 0.25, 1e-9);
  EXPECT_NEAR(half.Color(5.0).b, 1.0, 1e-9) << "red is not seen there";
  EXPECT_NEAR(half.Opacity(15.0), 0.5, 1e-9) << "0.75 over 2 mm is 0.5 over 1 mm";
  EXPECT_NEAR(half.Color(15.0).r, 0.5, 1e-9);
  EXPECT_NEAR(half.Opacity(10.0), 0.25, 1e-9) << "a step belongs to its left side";
}

TEST(SceneChange, OfALookBeginsWithItsCurveOverAnotherUnitDistance)
{
  Look ramp;
  ramp.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  ramp.opacities = { { 0.0, 0.0 }, { 10.0, 1.0 } };
  Look thick = ramp;
  thick.opacityUnitDistanceMm = 2.0 * ramp.opacityUnitDistanceMm;
  const TransferFunction first = CurvesOf(LookBetween(ramp, thick, 0.0));
  EXPECT_NEAR(first.Extinction(5.3), CurvesOf(ramp).Extinction(5.3), 0.01);
}

TEST(SceneChange, OfALookKeepsStepsAsTwoNodesAtOneValue)
{
  Look step;
  step.opacities = { { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 0.75 }, { 20.0, 0.75 } };
  Look flat = step;
  flat.opacities = { { 0.0, 0.5 }, { 20.0, 0.5 } };
  EXPECT_TRUE(CurvesOf(LookBetween(step, flat, 0.5)).HasStepAt(10.0));
}

TEST(SceneChange, IsForCompositesWithoutRegions)
{
  const Look bone = BuiltInPreset("ct-bone").look;
  EXPECT_FALSE(CanChange(bone, BuiltInPreset("ct-maximum").look));
  Look regions = bone;
  regions.regions.push_back({});
  EXPECT_FALSE(CanChange(regions, bone));
}

TEST(SceneChange, OfCutsBringsThemFromTheOutsideToTheirPlaces)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(11, 11, 11);
  SceneCuts cuts;
  cuts.box = { 0.2, 0.6, 0.0, 1.0, 0.0, 1.0 };
  cuts.planes = { { { 4.0, 5.0, 5.0 }, { 1.0, 0.0, 0.0 } } };
  const SceneCuts first = CutsOnTheirWay(cuts, image, 0.0);
  EXPECT_EQ(first.box, SceneCuts().box);
  EXPECT_NEAR(first.planes[0].pointMm[0], 0.0, 1e-9);
  const SceneCuts half = CutsOnTheirWay(cuts, image, 0.5);
  EXPECT_NEAR(half.box[0], 0.1, 1e-12);
  EXPECT_NEAR(half.box[1], 0.8, 1e-12);
  EXPECT_NEAR(half.planes[0].pointMm[0], 2.0, 1e-9);
  const SceneCuts last = CutsOnTheirWay(cuts, image, 1.0);
  EXPECT_EQ(last.box, cuts.box);
  EXPECT_NEAR(last.planes[0].pointMm[0], 4.0, 1e-9);
}
