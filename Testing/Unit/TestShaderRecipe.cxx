#include "Core/Recipe/ShaderRecipe.h"
#include "Support/EveryRecipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace varimarch;
using Parts = std::vector<std::string>;

namespace
{

const RenderSettings plain{ Blend::Composite, Acceleration::Off, false, false };

Parts Changed(const RenderSettings& settings)
{
  const Parts before = FragmentShaderParts(plain);
  const Parts after = FragmentShaderParts(settings);
  Parts added;
  std::copy_if(after.begin(), after.end(), std::back_inserter(added),
    [&](const std::string& part)
    { return std::find(before.begin(), before.end(), part) == before.end(); });
  return added;
}

}

TEST(ShaderRecipe, PlainCompositeTakesNothingItDoesNotNeed)
{
  EXPECT_EQ(FragmentShaderParts(plain),
    (Parts{ "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl", "Pixel/OfImage.glsl",
      "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl", "Spacing/Even.glsl",
      "Filter/OfDevice.glsl", "Difference/AsFiltered.glsl", "Interpolation/Linear.glsl",
      "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Step/Fixed.glsl",
      "Classify/OpticalTable.glsl", "Blend/Composite.glsl", "Loop/Segments.glsl",
      "FourScalars.glsl", "March/Midpoint.glsl", "Gaps/None.glsl", "Mask/None.glsl",
      "Crop/None.glsl", "Probe/None.glsl", "Window/None.glsl", "Resume/Whole.glsl",
      "Span/None.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, EachChoiceChangesItsOwnSlotsOnly)
{
  EXPECT_EQ(Changed({ Blend::Composite, Acceleration::CellField, false, false }),
    Parts{ "Step/CellField.glsl" });
  EXPECT_EQ(Changed({ Blend::Composite, Acceleration::VariationField, false, false }),
    Parts{ "Step/VariationField.glsl" });
  EXPECT_EQ(Changed({ Blend::Composite, Acceleration::OpticalField, false, false }),
    Parts{ "Step/OpticalField.glsl" });
  RenderSettings growing{ Blend::Composite, Acceleration::OpticalField, false, false };
  growing.skipsBricks = false;
  EXPECT_EQ(Changed(growing), Parts{ "Step/Growing.glsl" });
  EXPECT_EQ(Changed({ Blend::Composite, Acceleration::Off, true, false }),
    (Parts{ "Gradient/CentralDifferences.glsl", "Shade/HeadLight.glsl", "GradientOpacity/None.glsl",
      "Values/One.glsl", "Material/OneComponent.glsl", "Damping/None.glsl", "Sky/None.glsl",
      "March/MaterialMidpoint.glsl" }));
  EXPECT_EQ(
    Parts(Changed({ Blend::Composite, Acceleration::Off, true, false, Integration::PreIntegrated }))
      .back(),
    "March/MaterialSegments.glsl");
  RenderSettings lit{ Blend::Composite, Acceleration::Off, true, false };
  lit.lights = true;
  EXPECT_EQ(Changed(lit),
    (Parts{ "Gradient/CentralDifferences.glsl", "Shade/Lights.glsl", "GradientOpacity/None.glsl",
      "Values/One.glsl", "Material/OneComponent.glsl", "Reach/None.glsl", "Scatter/None.glsl",
      "Damping/None.glsl", "Sky/None.glsl", "March/MaterialMidpoint.glsl" }));
  RenderSettings gradient = plain;
  gradient.gradientOpacity = true;
  EXPECT_EQ(Changed(gradient),
    (Parts{ "Gradient/CentralDifferences.glsl", "Shade/None.glsl", "GradientOpacity/Table.glsl",
      "Values/One.glsl", "Material/OneComponent.glsl", "Sky/None.glsl",
      "March/MaterialMidpoint.glsl" }));
  EXPECT_EQ(Changed({ Blend::Composite, Acceleration::Off, false, true }),
    Parts{ "Depth/SceneGeometry.glsl" });
  RenderSettings counting = plain;
  counting.countFetches = true;
  EXPECT_EQ(Changed(counting), Parts{ "Probe/FetchCount.glsl" });
}

TEST(ShaderRecipe, EachChoiceOfThePictureChangesItsOwnSlotOnly)
{
  RenderSettings tried = plain;
  tried.triesRays = true;
  EXPECT_EQ(Changed(tried), Parts{ "Pixel/OfTrials.glsl" });
  RenderSettings jittered = plain;
  jittered.jitter = true;
  EXPECT_EQ(Changed(jittered), Parts{ "Jitter/BlueNoise.glsl" });
  RenderSettings windowed = plain;
  windowed.windowLevel = true;
  EXPECT_EQ(Changed(windowed), Parts{ "Window/WindowLevel.glsl" });
}

TEST(ShaderRecipe, DampingIsAFileOfItsSlotWhereThereIsLight)
{
  RenderSettings damped = plain;
  damped.damping = true;
  EXPECT_EQ(Changed(damped), Parts());
  damped.shading = true;
  const Parts parts = Changed(damped);
  EXPECT_EQ(std::count(parts.begin(), parts.end(), "Damping/Homogeneous.glsl"), 1);
}

TEST(ShaderRecipe, ScatteringAndSoftLightsTakeNothingWithoutLights)
{
  RenderSettings unlit = plain;
  unlit.lights = unlit.shadows = unlit.softLights = unlit.scattering = true;
  EXPECT_EQ(Changed(unlit), Parts()) << "a trial of opacities";
}

TEST(ShaderRecipe, ScatteringAndSoftLightsAreFilesOfTheirSlots)
{
  const auto partsOf = [](bool shadows, bool softLights, bool scattering)
  {
    RenderSettings lit = plain;
    lit.shading = lit.lights = true;
    lit.shadows = shadows;
    lit.softLights = softLights;
    lit.scattering = scattering;
    const Parts parts = Changed(lit);
    return Parts(std::find(parts.begin(), parts.end(), "Material/OneComponent.glsl") + 1,
      std::find(parts.begin(), parts.end(), "Damping/None.glsl"));
  };
  EXPECT_EQ(partsOf(false, false, false), (Parts{ "Reach/None.glsl", "Scatter/None.glsl" }));
  EXPECT_EQ(partsOf(false, true, false), (Parts{ "Reach/None.glsl", "Scatter/None.glsl" }));
  EXPECT_EQ(partsOf(true, false, false),
    (Parts{ "RaysInside.glsl", "Through/Segments.glsl", "Around/None.glsl", "Reach/ShadowRays.glsl",
      "Cone/None.glsl", "Casters/None.glsl", "Scatter/None.glsl" }));
  EXPECT_EQ(partsOf(true, true, true),
    (Parts{ "RaysInside.glsl", "Through/Segments.glsl", "Around/None.glsl", "Reach/ShadowRays.glsl",
      "Cone/Disc.glsl", "Casters/None.glsl", "Scatter/HenyeyGreenstein.glsl" }));
}

TEST(ShaderRecipe, CastersTakeNothingWithoutShadows)
{
  RenderSettings lit = plain;
  lit.shading = lit.lights = lit.casters = true;
  const auto has = [](const Parts& parts, const char* file)
  { return std::find(parts.begin(), parts.end(), file) != parts.end(); };
  EXPECT_FALSE(has(Changed(lit), "Casters/Triangles.glsl"));
  lit.shadows = true;
  EXPECT_TRUE(has(Changed(lit), "Casters/Triangles.glsl"));
}

TEST(ShaderRecipe, ASplineChangesHowTheVolumeIsReadAndItsGradients)
{
  RenderSettings cubic = plain;
  cubic.cubic = true;
  EXPECT_EQ(Changed(cubic), Parts{ "Interpolation/CubicSpline.glsl" });
  cubic.shading = true;
  const Parts lit = Changed(cubic);
  EXPECT_EQ(Parts(lit.begin(), lit.begin() + 2),
    (Parts{ "Interpolation/CubicSpline.glsl", "Gradient/OfSpline.glsl" }));
}

TEST(ShaderRecipe, TheOrderOfCompositingIsAMarchOfItsOwn)
{
  RenderSettings behind = plain;
  behind.fromBehind = true;
  EXPECT_EQ(Changed(behind), (Parts{ "FromBehind.glsl", "March/MidpointFromBehind.glsl" }));
  const Parts parts = FragmentShaderParts(behind);
  EXPECT_EQ(std::count(parts.begin(), parts.end(), "Loop/Segments.glsl"), 0);
  behind.shading = true;
  EXPECT_EQ(Changed(behind).back(), "March/MaterialFromBehind.glsl");
}

TEST(ShaderRecipe, StoredGradientsAreAFileOfTheirSlotWhereThereAreGradients)
{
  RenderSettings stored = plain;
  stored.storedGradients = true;
  EXPECT_EQ(Changed(stored), Parts());
  EXPECT_FALSE(ReadsStoredGradients(stored));
  stored.shading = true;
  EXPECT_EQ(Changed(stored).front(), "Gradient/Stored.glsl");
  EXPECT_TRUE(ReadsStoredGradients(stored));
  RenderSettings picture = stored;
  picture.pass = RayPass::Picture; // the last drawing of a frame in blocks
  EXPECT_TRUE(ReadsStoredGradients(picture));
  for (bool RenderSettings::*other :
    { &RenderSettings::cubic, &RenderSettings::uneven, &RenderSettings::clippedGradients })
  {
    RenderSettings without = stored;
    without.*other = true;
    EXPECT_FALSE(ReadsStoredGradients(without));
  }
}

TEST(ShaderRecipe, CutsChangeTheirOwnSlotsOnly)
{
  RenderSettings cuts = plain;
  cuts.clipping = true;
  EXPECT_EQ(Changed(cuts), Parts{ "Clip/Planes.glsl" });
  cuts.cropping = true;
  EXPECT_EQ(Changed(cuts), (Parts{ "Clip/Planes.glsl", "Crop/Regions.glsl" }));
}

TEST(ShaderRecipe, GapsTakeTheirWalkAndWhatFillsThem)
{
  RenderSettings gaps = plain;
  gaps.gaps = true;
  EXPECT_EQ(Changed(gaps), (Parts{ "Fill/None.glsl", "Gaps/Cells.glsl" }));
  gaps.fillGaps = true;
  EXPECT_EQ(Changed(gaps), (Parts{ "Fill/Color.glsl", "Gaps/Cells.glsl" }));
}

TEST(ShaderRecipe, VolumesWithoutGapsHaveNothingToFill)
{
  RenderSettings spanned = plain;
  spanned.limitsSpan = true;
  EXPECT_EQ(Changed(spanned), Parts{ "Span/Limited.glsl" });
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
    (Parts{ "Classify/PreIntegrated.glsl", "Loop/Segments.glsl", "FourScalars.glsl",
      "March/PreIntegrated.glsl" }));
  EXPECT_EQ(marchOf(Integration::Simpson),
    (Parts{ "Classify/OpticalTable.glsl", "Loop/Segments.glsl", "March/Simpson.glsl" }));
  EXPECT_EQ(marchOf(Integration::PublishedSum),
    (Parts{ "Classify/OpticalTable.glsl", "March/PublishedSum.glsl" }));
  EXPECT_EQ(
    marchOf(Integration::FirstHit), (Parts{ "Classify/OpticalTable.glsl", "March/FirstHit.glsl" }));
}

TEST(ShaderRecipe, MaximumIntensityHasNothingToShade)
{
  const RenderSettings maximum{ Blend::MaximumIntensity, Acceleration::Off, true, false };
  EXPECT_EQ(FragmentShaderParts(maximum),
    (Parts{ "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl", "Pixel/OfImage.glsl",
      "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl", "Spacing/Even.glsl",
      "Filter/OfDevice.glsl", "Difference/AsFiltered.glsl", "Interpolation/Linear.glsl",
      "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Step/Fixed.glsl",
      "Classify/OpticalTable.glsl", "Blend/MaximumIntensity.glsl", "Loop/Cells.glsl",
      "March/Extreme.glsl", "Gaps/None.glsl", "Mask/None.glsl", "Crop/None.glsl", "Probe/None.glsl",
      "Window/None.glsl", "Resume/Whole.glsl", "Span/None.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, ExactMarchesTakeNoSampleSteps)
{
  const auto partsOf = [](Blend blend, bool nearest)
  {
    RenderSettings settings{ blend, Acceleration::Off };
    settings.nearest = nearest;
    const Parts parts = FragmentShaderParts(settings);
    // Compare only the parts between the common beginning and the common end.
    return Parts(parts.begin() + 11, std::find(parts.begin(), parts.end(), "Gaps/None.glsl"));
  };
  EXPECT_EQ(partsOf(Blend::Composite, true),
    (Parts{ "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Step/Fixed.glsl",
      "Classify/OpticalTable.glsl", "Blend/Composite.glsl", "Loop/Cells.glsl",
      "March/Voxels.glsl" }));
  EXPECT_EQ(partsOf(Blend::MinimumIntensity, true),
    (Parts{ "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Step/Fixed.glsl",
      "Classify/OpticalTable.glsl", "Blend/MinimumIntensity.glsl", "Loop/Cells.glsl",
      "March/ProjectedVoxels.glsl" }));
  EXPECT_EQ(partsOf(Blend::Isosurface, false),
    (Parts{ "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Step/Fixed.glsl",
      "Gradient/CentralDifferences.glsl", "Shade/None.glsl", "Blend/Composite.glsl",
      "Loop/Cells.glsl", "SurfaceTable.glsl", "March/Isosurfaces.glsl" }));
  EXPECT_EQ(partsOf(Blend::Slice, false),
    (Parts{ "Depth/None.glsl", "Clip/None.glsl", "Classify/OpticalTable.glsl", "Gradient/None.glsl",
      "Shade/None.glsl", "GradientOpacity/None.glsl", "Values/One.glsl",
      "Material/OneComponent.glsl", "Blend/Composite.glsl", "March/Slice.glsl" }));
}

TEST(ShaderRecipe, VolumesThatOverlapTakeTheirOwnFilesAndOneMarch)
{
  RenderSettings settings{ Blend::Composite, Acceleration::Off };
  settings.overlaps = true;
  RenderSettings lit = settings;
  lit.shading = true;
  settings.others = { lit };
  const Parts parts = FragmentShaderParts(settings);
  EXPECT_EQ(parts,
    (Parts{ "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl", "Pixel/OfImage.glsl",
      "Depth/None.glsl", "Clip/None.glsl", "Jitter/None.glsl", "Blend/Composite.glsl",
      "Volumes/None.glsl",
      // The lit volume.
      "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl", "Spacing/Even.glsl",
      "Filter/OfDevice.glsl", "Difference/AsFiltered.glsl", "Interpolation/Linear.glsl",
      "Probe/None.glsl", "Gaps/None.glsl", "Classify/OpticalTable.glsl",
      "Gradient/CentralDifferences.glsl", "Shade/HeadLight.glsl", "GradientOpacity/None.glsl",
      "Values/One.glsl", "Material/OneComponent.glsl", "Damping/None.glsl", "Step/Fixed.glsl",
      "Sky/None.glsl", "Reading/Cells.glsl", "Volumes/Next.glsl",
      // The other volume.
      "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl", "Spacing/Even.glsl",
      "Filter/OfDevice.glsl", "Difference/AsFiltered.glsl", "Interpolation/Linear.glsl",
      "Probe/None.glsl", "Gaps/None.glsl", "Classify/OpticalTable.glsl", "Gradient/None.glsl",
      "Shade/None.glsl", "GradientOpacity/None.glsl", "Values/One.glsl",
      "Material/OneComponent.glsl", "Step/Fixed.glsl", "Sky/None.glsl", "Reading/Cells.glsl",
      "Volumes/Next.glsl", "March/Several.glsl", "Mask/None.glsl", "Crop/None.glsl",
      "Window/None.glsl", "Resume/Whole.glsl", "Span/None.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, ThePictureOfBlocksIsMadeWithoutAMarch)
{
  RenderSettings settings{ Blend::Composite, Acceleration::OpticalField, true, false };
  settings.pass = RayPass::Picture;
  EXPECT_EQ(FragmentShaderParts(settings),
    (Parts{ "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl", "Pixel/OfImage.glsl",
      "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl", "Depth/None.glsl",
      "Clip/None.glsl", "Blend/Composite.glsl", "Window/None.glsl", "Resume/Picture.glsl",
      "Span/None.glsl", "RayMarch.frag.glsl" }));
}

TEST(ShaderRecipe, EveryRecipeIsListedOnce)
{
  std::set<Parts> distinct;
  for (const RenderSettings& settings : EveryRecipe())
  {
    EXPECT_TRUE(distinct.insert(FragmentShaderParts(settings)).second);
  }
  EXPECT_EQ(distinct.size(), 294u);
}

TEST(ShaderRecipe, EveryRecipeFillsASlotAtMostOnce)
{
  for (const RenderSettings& settings : EveryRecipe())
  {
    std::map<std::string, int> filesOfSlot;
    for (const std::string& part : FragmentShaderParts(settings))
    {
      if (part == "VolumeSlots.glsl")
      {
        filesOfSlot.clear(); // each volume has its own files
      }
      const std::size_t slash = part.find('/');
      if (slash != std::string::npos && part.substr(0, slash) != "Math")
      {
        EXPECT_EQ(++filesOfSlot[part.substr(0, slash)], 1) << part;
      }
    }
  }
}
