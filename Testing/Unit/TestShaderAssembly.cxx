#include "Core/Recipe/ShaderAssembly.h"

#include <gtest/gtest.h>

using varimarch::AssembleShader;
using varimarch::TraceShaderErrors;

namespace
{
const std::vector<varimarch::ShaderFile> files = {
  { "Slots.glsl", "float Value();\n" },
  { "Step/Fixed.glsl", "float step;\nfloat Value() { return step; }\n" },
};
}

TEST(ShaderAssembly, PutsTheVersionFirstAndTheFilesInOrder)
{
  EXPECT_EQ(AssembleShader(files),
    "#version 150\n"
    "#line 1000\nfloat Value();\n\n"
    "#line 2000\nfloat step;\nfloat Value() { return step; }\n\n");
}

TEST(ShaderAssembly, PutsEachIncludedFileInFrontOnce)
{
  const std::vector<varimarch::ShaderFile> including = {
    { "Step/Fixed.glsl", "#include \"Math/A.glsl\"\n#include \"Math/B.glsl\"\nfloat step;\n" },
    { "March/Midpoint.glsl", "#include \"Math/B.glsl\" // for sums\nfloat sum;\n" },
  };
  const std::vector<varimarch::ShaderFile> found =
    varimarch::WithIncludes(including, [](const std::string& path) { return "text of " + path; });
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].path, "Math/A.glsl");
  EXPECT_EQ(found[1].path, "Math/B.glsl");
  EXPECT_EQ(found[1].text, "text of Math/B.glsl");
  EXPECT_EQ(found[2].text, "\n\nfloat step;\n") << "lines keep their numbers";
  EXPECT_EQ(found[3].text, "\nfloat sum;\n");
}

TEST(ShaderAssembly, TracesMessagesOfEveryCompilerToFileAndLine)
{
  EXPECT_EQ(TraceShaderErrors("0:2002(7): error: `step' undeclared", files),
    "Step/Fixed.glsl:2: error: `step' undeclared");
  EXPECT_EQ(TraceShaderErrors("ERROR: 0:1001: '' : syntax error", files),
    "ERROR: Slots.glsl:1: '' : syntax error");
  EXPECT_EQ(TraceShaderErrors("0(2001) : error C1008\n0(1001) : warning", files),
    "Step/Fixed.glsl:1 : error C1008\nSlots.glsl:1 : warning");
}

TEST(ShaderAssembly, LeavesNumbersOutsideItsFilesAlone)
{
  EXPECT_EQ(TraceShaderErrors("0:9001: error, 10:30 lost", files), "0:9001: error, 10:30 lost");
}

TEST(ShaderAssembly, GivesEachOfSeveralVolumesNamesOfItsOwn)
{
  const std::vector<varimarch::ShaderFile> volume = {
    { "VolumeParameters.glsl", "uniform float own;\n" },
    { "Volumes/Next.glsl", "float Sum()\n{\n  return SumBefore() + own;\n}\n" },
  };
  std::vector<varimarch::ShaderFile> several = { { "Volumes/None.glsl", "float SumBefore();\n" } };
  for (int i = 0; i < 3; ++i)
  {
    several.insert(several.end(), volume.begin(), volume.end());
  }
  const std::string text = volume.front().text + "\n#line 3000\n" + volume.back().text + "\n";
  const std::string source = AssembleShader(several);
  const auto stands = [&](const std::string& part)
  { return source.find(part) != std::string::npos; };
  // The first volume declares SumBefore; each further one defines it as the Sum of the one before.
  EXPECT_TRUE(stands("#line 1000\nfloat SumBefore();\n\n"
                     "#define Sum Sum_1\n#define own own_1\n#line 2000\n" +
    text));
  EXPECT_TRUE(stands("#undef SumBefore\n#define SumBefore Sum_1\n#undef Sum\n#undef own\n"
                     "#define Sum Sum_2\n#define own own_2\n#line 4000\n"));
  EXPECT_TRUE(stands("#undef SumBefore\n#define SumBefore Sum_2\n#undef Sum\n#undef own\n"
                     "#line 6000\n"));
  EXPECT_EQ(varimarch::NameOfVolume("own", 0), "own_1");
}

TEST(ShaderAssembly, GivesEachOfSeveralVolumesABlockOfItsOwn)
{
  const varimarch::ShaderFile block = { "VolumeParameters.glsl",
    "layout(std140) uniform VolumeParameters\n{\n  vec3 size; // [mm]\n};\n" };
  const std::string source = AssembleShader({ block, block });
  EXPECT_NE(source.find("#define VolumeParameters VolumeParameters_1\n#define size size_1\n"),
    std::string::npos);
}
