#include "Core/Recipe/ShaderAssembly.h"

#include <gtest/gtest.h>

using varimarch::HandParametersOn;
using varimarch::ShaderFile;

namespace
{

constexpr int Enough = 100;

ShaderFile Block(const std::string& members)
{
  return { "RayParameters.glsl", "layout(std140) uniform RayParameters\n{\n" + members + "};\n" };
}

class FlatParameters : public testing::Test
{
protected:
  // The text inserted after the blocks of the fragment shader.
  std::string Passed(const std::string& members, int mostComponents = Enough)
  {
    this->fragment[0] = Block(members);
    HandParametersOn(this->vertex, this->fragment, mostComponents);
    return this->fragment[1].text;
  }

  std::vector<ShaderFile> vertex = { { "PassParameters.glsl", "void PassParameters() {}\n" } };
  std::vector<ShaderFile> fragment = { {},
    { "Step/Fixed.glsl",
      "float Step() { return size.x * box.y + rows[1].x + sizes + second; }\n" } };
};

}

TEST_F(FlatParameters, AreReadByTheVertexShaderAndHandedOn)
{
  EXPECT_EQ(
    this->Passed("  vec3 size; // [mm]\n"), "flat in vec3 sizeFlat;\n#define size sizeFlat\n");
  EXPECT_EQ(this->vertex[0].text,
    "flat out vec3 sizeFlat;\n\nvoid PassParameters()\n{\n  sizeFlat = size;\n}\n");
}

TEST_F(FlatParameters, MayBeArrays)
{
  EXPECT_EQ(
    this->Passed("  vec4 rows[3];\n"), "flat in vec4 rowsFlat[3];\n#define rows rowsFlat\n");
}

TEST_F(FlatParameters, ThatTheShaderDoesNotNameStayInTheBlock)
{
  EXPECT_EQ(this->Passed("  vec3 other;\n  float siz;\n"), "");
}

TEST_F(FlatParameters, AreAsManyAsThereAreVariablesForInTheOrderOfTheBlock)
{
  EXPECT_EQ(this->Passed("  vec4 rows[3];\n  vec3 size;\n  float second;\n", 4),
    "flat in vec3 sizeFlat;\n#define size sizeFlat\n"
    "flat in float secondFlat;\n#define second secondFlat\n");
}

TEST_F(FlatParameters, OfSeveralVolumesStayInTheirBlocks)
{
  this->fragment = { { "VolumeParameters.glsl", "" }, { "VolumeParameters.glsl", "" } };
  HandParametersOn(this->vertex, this->fragment, Enough);
  EXPECT_EQ(this->fragment.size(), 2);
  EXPECT_EQ(this->vertex[0].text, "void PassParameters() {}\n");
}

TEST_F(FlatParameters, AreFoundInABlockOfAnyLength)
{
  std::string members;
  for (int i = 0; i < 50000; ++i)
  {
    members += "  vec3 unused" + std::to_string(i) + ";\n";
  }
  EXPECT_EQ(
    this->Passed(members + "  vec3 size;\n"), "flat in vec3 sizeFlat;\n#define size sizeFlat\n");
}
