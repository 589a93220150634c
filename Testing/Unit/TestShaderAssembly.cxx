#include "Core/ShaderAssembly.h"

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
