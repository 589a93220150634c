#include "Core/UniformsReadOnce.h"

#include <gtest/gtest.h>

using varimarch::ShaderFile;
using varimarch::WithUniformsReadOnce;

namespace
{

const ShaderFile main = { "RayMarch.frag.glsl",
  "void main()\n{\n  // Uniforms read once are read here.\n  Draw(size);\n}\n" };
const ShaderFile unity = { "Unity.glsl", "uniform float unity = 1.0;\n" };

}

TEST(UniformsReadOnce, AreVariablesWhereverTheyAreUsed)
{
  const std::vector<ShaderFile> files = WithUniformsReadOnce(
    {
      { "Step/Fixed.glsl",
        "uniform vec3 size; // [mm]\nfloat Step() { return size.x * box.size + sizes; }\n" },
      main,
    },
    unity);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[1].text, unity.text);
  EXPECT_EQ(files[0].text,
    "uniform vec3 size; vec3 sizeOnce; // [mm]\n"
    "float Step() { return sizeOnce.x * box.size + sizes; }\n");
  EXPECT_EQ(files[2].text,
    "void main()\n"
    "{\n"
    " sizeOnce = size * unity;\n"
    "  Draw(sizeOnce);\n"
    "}\n");
}

TEST(UniformsReadOnce, WholeNumbersStayWhole)
{
  const std::vector<ShaderFile> files =
    WithUniformsReadOnce({ { "Slots.glsl", "uniform ivec2 size;\n" }, main }, unity);
  EXPECT_NE(files[2].text.find(" sizeOnce = size * int(unity);\n"), std::string::npos);
}

TEST(UniformsReadOnce, ArraysSamplersAndSwitchesStayWhereTheyAre)
{
  const ShaderFile others = { "Slots.glsl",
    "uniform vec4 rows[3];\nuniform sampler3D voxels;\nuniform bool on;\n" };
  EXPECT_EQ(WithUniformsReadOnce({ others, main }, unity)[0].text, others.text);
}

TEST(UniformsReadOnce, SeveralVolumesAreLeftAsTheyAre)
{
  const std::vector<ShaderFile> files = { { "VolumeSlots.glsl", "uniform float size;\n" },
    { "VolumeSlots.glsl", "uniform float size;\n" }, main };
  const std::vector<ShaderFile> same = WithUniformsReadOnce(files, unity);
  ASSERT_EQ(same.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    EXPECT_EQ(same[i].text, files[i].text);
  }
}

TEST(UniformsReadOnce, AShaderWithoutAPlaceForThemIsLeftAsItIs)
{
  const ShaderFile whole = { "Mean.frag.glsl", "uniform float count;\n" };
  EXPECT_EQ(WithUniformsReadOnce({ whole }, unity).front().text, whole.text);
}
