#include "Core/Recipe/FlatUniforms.h"

#include <gtest/gtest.h>

using varimarch::HandUniformsOn;
using varimarch::ShaderFile;

namespace
{

constexpr int Enough = 100;

class FlatUniforms : public testing::Test
{
protected:
  std::vector<ShaderFile> vertex = { { "RayMarch.vert.glsl",
    "uniform mat4 place;\n"
    "// Uniforms of the fragment shader are declared here.\n"
    "void main()\n"
    "{\n"
    "  // And handed on here.\n"
    "}\n" } };
  std::vector<ShaderFile> fragment = { { "Step/Fixed.glsl",
    "uniform vec3 size; // [mm]\n"
    "float Step() { return size.x * box.size + sizes; }\n" } };
};

}

TEST_F(FlatUniforms, AreReadByTheVertexShaderAndHandedOn)
{
  HandUniformsOn(this->vertex, this->fragment, Enough);
  EXPECT_EQ(this->fragment[0].text,
    "flat in vec3 sizeFlat; // [mm]\n"
    "float Step() { return sizeFlat.x * box.size + sizes; }\n");
  EXPECT_EQ(this->vertex[0].text,
    "uniform mat4 place;\n"
    "uniform vec3 size; flat out vec3 sizeFlat; \n"
    "void main()\n"
    "{\n"
    "sizeFlat = size; \n"
    "}\n");
}

TEST_F(FlatUniforms, ThatTheVertexShaderHasAreNotDeclaredTwice)
{
  this->fragment[0].text = "uniform mat4 place;\n";
  HandUniformsOn(this->vertex, this->fragment, Enough);
  EXPECT_NE(this->vertex[0].text.find("\nflat out mat4 placeFlat; \n"), std::string::npos);
  EXPECT_NE(this->vertex[0].text.find("placeFlat = place; "), std::string::npos);
}

TEST_F(FlatUniforms, ArraysSamplersAndSwitchesStayWhereTheyAre)
{
  const std::string text = "uniform vec4 rows[3];\nuniform sampler3D voxels;\nuniform bool on;\n";
  this->fragment[0].text = text;
  HandUniformsOn(this->vertex, this->fragment, Enough);
  EXPECT_EQ(this->fragment[0].text, text);
}

TEST_F(FlatUniforms, AreAsManyAsThereAreVariablesFor)
{
  this->fragment[0].text =
    "uniform mat3 turn;\nuniform vec2 first;\nuniform float second;\nuniform int third;\n";
  HandUniformsOn(this->vertex, this->fragment, 4);
  EXPECT_EQ(this->fragment[0].text,
    "uniform mat3 turn;\nflat in vec2 firstFlat;\nflat in float secondFlat;\n"
    "flat in int thirdFlat;\n");
}

TEST_F(FlatUniforms, OfSeveralVolumesStayUniforms)
{
  this->fragment = { { "VolumeSlots.glsl", "uniform float size;\n" },
    { "VolumeSlots.glsl", "uniform float size;\n" } };
  const std::string before = this->vertex[0].text;
  HandUniformsOn(this->vertex, this->fragment, Enough);
  EXPECT_EQ(this->fragment[0].text, "uniform float size;\n");
  EXPECT_EQ(this->vertex[0].text, before);
}
