#include "Core/ShaderRecipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace varimarch;
using Parts = std::vector<std::string>;

TEST(ShaderRecipe, PlainCompositeTakesNothingItDoesNotNeed)
{
  const RenderSettings plain{ Blend::Composite, Acceleration::Off, false, false };
  EXPECT_EQ(FragmentShaderParts(plain),
    (Parts{ "Slots.glsl", "Math/IntersectBox.glsl", "Math/Absorption.glsl", "Depth/None.glsl",
      "Step/Fixed.glsl", "Classify/OpticalTable.glsl", "Blend/Composite.glsl",
      "Fetch/FourScalars.glsl", "March/Midpoint.glsl", "Gaps/None.glsl", "Probe/None.glsl",
      "Resume/Whole.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, EachChoiceChangesItsOwnSlotsOnly)
{
  const RenderSettings plain{ Blend::Composite, Acceleration::Off, false, false };
  const auto changed = [&](RenderSettings settings)
  {
    const Parts before = FragmentShaderParts(plain);
    const Parts after = FragmentShaderParts(settings);
    Parts added;
    std::copy_if(after.begin(), after.end(), std::back_inserter(added),
      [&](const std::string& part)
      { return std::find(before.begin(), before.end(), part) == before.end(); });
    return added;
  };
  EXPECT_EQ(changed({ Blend::Composite, Acceleration::ScalarField, false, false }),
    Parts{ "Step/VariationField.glsl" });
  EXPECT_EQ(changed({ Blend::Composite, Acceleration::OpticalField, false, false }),
    (Parts{ "Math/LatticeWalk.glsl", "Step/OpticalField.glsl" }));
  EXPECT_EQ(changed({ Blend::Composite, Acceleration::Off, true, false }),
    (Parts{ "Gradient/CentralDifferences.glsl", "Shade/HeadLight.glsl", "GradientOpacity/None.glsl",
      "Material/OneComponent.glsl", "March/MaterialSegments.glsl" }));
  RenderSettings lit{ Blend::Composite, Acceleration::Off, true, false };
  lit.lights = true;
  EXPECT_EQ(changed(lit),
    (Parts{ "Gradient/CentralDifferences.glsl", "Shade/Lights.glsl", "GradientOpacity/None.glsl",
      "Material/OneComponent.glsl", "March/MaterialSegments.glsl" }));
  RenderSettings gradient = plain;
  gradient.gradientOpacity = true;
  EXPECT_EQ(changed(gradient),
    (Parts{ "Math/WithOpacityFactor.glsl", "Gradient/CentralDifferences.glsl", "Shade/None.glsl",
      "GradientOpacity/Table.glsl", "Material/OneComponent.glsl", "March/MaterialSegments.glsl" }));
  EXPECT_EQ(changed({ Blend::Composite, Acceleration::Off, false, true }),
    Parts{ "Depth/SceneGeometry.glsl" });
  RenderSettings counting = plain;
  counting.countFetches = true;
  EXPECT_EQ(changed(counting), Parts{ "Probe/FetchCount.glsl" });
  RenderSettings gaps = plain;
  gaps.gaps = true;
  EXPECT_EQ(changed(gaps), (Parts{ "Math/LatticeWalk.glsl", "Fill/None.glsl", "Gaps/Cells.glsl" }));
  gaps.fillGaps = true;
  EXPECT_EQ(
    changed(gaps), (Parts{ "Math/LatticeWalk.glsl", "Fill/Color.glsl", "Gaps/Cells.glsl" }));
}

TEST(ShaderRecipe, VolumesWithoutGapsHaveNothingToFill)
{
  RenderSettings settings;
  settings.fillGaps = true;
  EXPECT_EQ(FragmentShaderParts(settings), FragmentShaderParts(RenderSettings()));
}

TEST(ShaderRecipe, ARuleOfIntegrationIsItsMarchAndWhatThatLooksUp)
{
  const auto marchOf = [](Integration integration)
  {
    const Parts parts =
      FragmentShaderParts({ Blend::Composite, Acceleration::Off, false, false, integration });
    const auto blend = std::find(parts.begin(), parts.end(), "Blend/Composite.glsl");
    Parts march(blend + 1, std::find(parts.begin(), parts.end(), "Gaps/None.glsl"));
    march.insert(march.begin(), *(blend - 1));
    return march;
  };
  EXPECT_EQ(marchOf(Integration::PreIntegrated),
    (Parts{ "Classify/PreIntegrated.glsl", "Fetch/FourScalars.glsl", "March/PreIntegrated.glsl" }));
  EXPECT_EQ(
    marchOf(Integration::Simpson), (Parts{ "Classify/OpticalTable.glsl", "March/Simpson.glsl" }));
  EXPECT_EQ(marchOf(Integration::PublishedSum),
    (Parts{ "Classify/OpticalTable.glsl", "March/PublishedSum.glsl" }));
}

TEST(ShaderRecipe, MaximumIntensityHasNothingToShade)
{
  const RenderSettings maximum{ Blend::MaximumIntensity, Acceleration::Off, true, false };
  EXPECT_EQ(FragmentShaderParts(maximum),
    (Parts{ "Slots.glsl", "Math/IntersectBox.glsl", "Math/Absorption.glsl", "Depth/None.glsl",
      "Step/Fixed.glsl", "Classify/OpticalTable.glsl", "Blend/MaximumIntensity.glsl",
      "March/Extreme.glsl", "Gaps/None.glsl", "Probe/None.glsl", "Resume/Whole.glsl",
      "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, ThePictureOfBlocksIsMadeWithoutAMarch)
{
  RenderSettings settings{ Blend::Composite, Acceleration::OpticalField, true, false };
  settings.pass = RayPass::Picture;
  EXPECT_EQ(FragmentShaderParts(settings),
    (Parts{ "Slots.glsl", "Math/IntersectBox.glsl", "Math/Absorption.glsl", "Depth/None.glsl",
      "Blend/Composite.glsl", "Resume/Picture.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, EveryRecipeIsListedOnce)
{
  std::set<Parts> distinct;
  for (const RenderSettings& settings : EveryRecipe())
  {
    EXPECT_TRUE(distinct.insert(FragmentShaderParts(settings)).second);
  }
  EXPECT_EQ(distinct.size(), 68u);
}

TEST(ShaderRecipe, EveryRecipeFillsASlotAtMostOnce)
{
  for (const RenderSettings& settings : EveryRecipe())
  {
    std::map<std::string, int> filesOfSlot;
    for (const std::string& part : FragmentShaderParts(settings))
    {
      const std::size_t slash = part.find('/');
      if (slash != std::string::npos && part.substr(0, slash) != "Math")
      {
        EXPECT_EQ(++filesOfSlot[part.substr(0, slash)], 1) << part;
      }
    }
  }
}
