#include "ShaderValidation.h"
#include "Support/EveryRecipe.h"

#include "Core/Recipe/PassRecipe.h"
#include "Core/Recipe/ShaderAssembly.h"
#include "Core/Recipe/ShaderRecipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

using namespace varimarch;

namespace
{

std::string Describe(const std::vector<std::string>& parts)
{
  std::string text;
  for (const std::string& part : parts)
  {
    text += part + " ";
  }
  return text;
}

}

TEST(Shaders, EveryRecipeCompiles)
{
  std::vector<StagedShader> shaders;
  for (const RenderSettings& settings : EveryRecipe())
  {
    shaders.push_back({ LoadParts(FragmentShaderParts(settings)), "frag" });
  }
  EXPECT_EQ(FaultsOf(shaders), std::vector<std::string>());
}

// The limit of llvmpipe.
constexpr int MostFlatComponents = 124;

TEST(Shaders, EveryRecipeCompilesWithFlatParameters)
{
  std::vector<StagedShader> shaders;
  for (const RenderSettings& settings : EveryRecipe())
  {
    StagedShader vertex{ LoadParts(VertexShaderParts()), "vert" };
    StagedShader fragment{ LoadParts(FragmentShaderParts(settings)), "frag" };
    HandParametersOn(vertex.files, fragment.files, MostFlatComponents);
    shaders.insert(shaders.end(), { vertex, fragment });
  }
  EXPECT_EQ(FaultsOf(shaders), std::vector<std::string>());
}

TEST(Shaders, IncludeOnlyFormulasThatTheyUse)
{
  static const std::regex function(R"((?:^|\n)\w+ (\w+)\()");
  for (const RenderSettings& settings : EveryRecipe())
  {
    const std::vector<ShaderFile> files = LoadParts(FragmentShaderParts(settings));
    for (const ShaderFile& formulas : files)
    {
      if (formulas.path.rfind("Math/", 0) != 0)
      {
        continue;
      }
      bool isUsed = false;
      for (std::sregex_iterator match(formulas.text.begin(), formulas.text.end(), function), none;
           match != none && !isUsed; ++match)
      {
        const std::string call = (*match)[1].str() + "(";
        isUsed = std::any_of(files.begin(), files.end(),
          [&](const ShaderFile& file)
          { return &file != &formulas && file.text.find(call) != std::string::npos; });
      }
      EXPECT_TRUE(isUsed) << formulas.path << " in " << Describe(FragmentShaderParts(settings));
    }
  }
}

TEST(Shaders, PlainCompositesHaveFourFormulas)
{
  const RenderSettings plain{ Blend::Composite, Acceleration::Off };
  std::vector<std::string> formulas;
  for (const ShaderFile& file : LoadParts(FragmentShaderParts(plain)))
  {
    if (file.path.rfind("Math/", 0) == 0)
    {
      formulas.push_back(file.path);
    }
  }
  EXPECT_EQ(formulas,
    (std::vector<std::string>{
      "Math/Tables.glsl", "Math/Absorption.glsl", "Math/IntersectBox.glsl", "Math/Planes.glsl" }));
}

TEST(Shaders, TheVertexShaderCompiles)
{
  const ShaderValidation validation = Validate({ LoadParts(VertexShaderParts()), "vert" });
  EXPECT_TRUE(validation.passed) << validation.messages;
}

TEST(Shaders, AnErrorIsTracedToItsFileAndLine)
{
  const StagedShader right{ LoadParts(FragmentShaderParts(EveryRecipe().front())), "frag" };
  StagedShader wrong = right;
  const auto file = std::find_if(wrong.files.begin(), wrong.files.end(),
    [](const ShaderFile& one) { return one.path == "Depth/None.glsl"; });
  ASSERT_NE(file, wrong.files.end());
  file->text = "\nfloat DepthLimit(Ray ray) { return missing; }\n";
  const std::vector<std::string> faults = FaultsOf({ right, wrong, right });
  ASSERT_EQ(faults.size(), 1);
  EXPECT_NE(faults.front().find("Depth/None.glsl:2"), std::string::npos) << faults.front();
}
