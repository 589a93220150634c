// The files of shaders for light from all around, and for light that several volumes share.

#include "Core/Recipe/ShaderRecipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace varimarch;
using Parts = std::vector<std::string>;

TEST(LightRecipe, AmbientOcclusionIsAFileOfItsSlotWithRaysThroughTheVolume)
{
  const auto partsOf = [](const RenderSettings& settings)
  {
    const Parts wanted = { "Gradient/", "Through/", "Outside/", "Sky/" };
    Parts found;
    for (const std::string& part : FragmentShaderParts(settings))
    {
      const std::string slot = part.substr(0, part.find('/') + 1);
      if (std::count(wanted.begin(), wanted.end(), slot) > 0)
      {
        found.push_back(part);
      }
    }
    return found;
  };
  RenderSettings settings{ Blend::Composite, Acceleration::Off };
  EXPECT_EQ(partsOf(settings), Parts());
  settings.occlusion = true;
  EXPECT_EQ(partsOf(settings),
    (Parts{ "Gradient/CentralDifferences.glsl", "Through/Segments.glsl", "Outside/Scalars.glsl",
      "Sky/OpenSky.glsl" }));
  settings.functionOf = FunctionOf::TwoValues;
  EXPECT_EQ(partsOf(settings).front(), "Gradient/CentralDifferences.glsl");
  settings.functionOf = FunctionOf::Value;
  settings.nearest = true;
  EXPECT_EQ(partsOf(settings)[1], "Through/Voxels.glsl");
  settings.uneven = true;
  EXPECT_EQ(partsOf(settings)[1], "Through/Segments.glsl");
  settings.mask = Mask::Labels;
  settings.labelSurfaces = true;
  EXPECT_EQ(partsOf(settings)[2], "Outside/Labels.glsl");
  RenderSettings components{ Blend::Composite, Acceleration::Off };
  components.components = Components::Rgba;
  components.occlusion = true;
  EXPECT_EQ(partsOf(components),
    (Parts{ "Gradient/CentralDifferencesOfAll.glsl", "Through/Segments.glsl",
      "Outside/Components.glsl", "Sky/OpenSky.glsl" }));
}

TEST(LightRecipe, VolumesThatTakeLightFromEachOtherHaveFilesForIt)
{
  RenderSettings unlit;
  unlit.overlaps = true;
  RenderSettings lit = unlit;
  lit.shading = lit.lights = lit.shadows = true;
  const auto countOf = [](const RenderSettings& settings, const char* file)
  {
    const Parts parts = FragmentShaderParts(settings);
    return std::count(parts.begin(), parts.end(), file);
  };
  for (const bool areInShadow : { false, true })
  {
    unlit.shadowsOthers = lit.shadowsOthers = lit.shadows = areInShadow;
    RenderSettings first = unlit;
    first.others = { lit, lit };
    EXPECT_EQ(countOf(first, "Around/Volumes.glsl"), areInShadow ? 3 : 0);
    EXPECT_EQ(countOf(first, "Reach/ShadowRays.glsl"), areInShadow ? 2 : 0);
    EXPECT_EQ(countOf(first, "DepthOfNone.glsl"), areInShadow ? 1 : 0);
    EXPECT_EQ(countOf(first, "DepthOfAll.glsl"), areInShadow ? 1 : 0);
    EXPECT_EQ(countOf(first, "Sky/None.glsl"), 3);
    first.occludesOthers = first.others[0].occludesOthers = first.others[1].occludesOthers = true;
    first.others[0].occlusion = true;
    EXPECT_EQ(countOf(first, "Around/Volumes.glsl"), 3);
    EXPECT_EQ(countOf(first, "Sky/OpenSky.glsl"), 1);
    EXPECT_EQ(countOf(first, "DepthOfAll.glsl"), 1);
  }
}
