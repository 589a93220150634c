#include "Core/Recipe/ShaderRecipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

bool HasFile(const RenderSettings& settings, const std::string& file)
{
  const std::vector<std::string> parts = FragmentShaderParts(settings);
  return std::find(parts.begin(), parts.end(), file) != parts.end();
}

RenderSettings LitOnACard()
{
  RenderSettings settings;
  settings.shading = true;
  settings.filter = Filter::OfTexels;
  return settings;
}

}

TEST(FilterRecipe, LightTakesGradientsFromTheDeviceThatRoundsWeights)
{
  EXPECT_TRUE(HasFile(LitOnACard(), "Filter/OfTexels.glsl"));
  EXPECT_TRUE(HasFile(LitOnACard(), "Difference/OfDevice.glsl"));
}

TEST(FilterRecipe, OpacityTakesGradientsFromTexels)
{
  RenderSettings ofGradient = LitOnACard();
  ofGradient.gradientOpacity = true;
  RenderSettings ofBoth = LitOnACard();
  ofBoth.functionOf = FunctionOf::ValueAndGradient;
  EXPECT_TRUE(HasFile(ofGradient, "Difference/AsFiltered.glsl"));
  EXPECT_TRUE(HasFile(ofBoth, "Difference/AsFiltered.glsl"));
}

TEST(FilterRecipe, UnevenVoxelsTakeGradientsFromTexels)
{
  RenderSettings settings = LitOnACard();
  settings.uneven = true;
  EXPECT_TRUE(HasFile(settings, "Difference/AsFiltered.glsl"));
}
