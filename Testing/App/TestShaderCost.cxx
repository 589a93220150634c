#include "Benchmarks/ShaderCost.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>

using namespace varimarch;

TEST(CapturedErrors, AreAllThatWasWrittenMeanwhile)
{
  const std::string captured = ErrorsDuring(
    []
    {
      std::cerr << "of C++, ";
      std::fprintf(stderr, "of C\n");
    });
  EXPECT_EQ(captured, "of C++, of C\n");
}

TEST(InstructionCount, IsThatOfTheLongestFragmentShader)
{
  ProgramCost cost;
  CountInstructions("shader: MESA_SHADER_VERTEX\ninputs: 1\n"
                    "\tvec1 32 ssa_0 = fadd ssa_1, ssa_2\n"
                    "\tvec1 32 ssa_3 = fadd ssa_1, ssa_2\n"
                    "\tvec1 32 ssa_4 = fadd ssa_1, ssa_2\n"
                    "shader: MESA_SHADER_FRAGMENT\ninputs: 23\n"
                    "\tvec1 32 ssa_0 = load_const (0x00000000 = 0.000000)\n"
                    "\tvec1 32 ssa_1 = deref_var &fragOutput0 (shader_out vec4)\n"
                    "\t\tvec4 32 ssa_2 = (float32)txl ssa_1 (coord), ssa_0 (lod), 0 (texture)\n"
                    "\tintrinsic store_deref (ssa_1, ssa_2) (wrmask=xyzw, access=0)\n"
                    "shader: MESA_SHADER_FRAGMENT\ninputs: 2\n"
                    "\tvec1 32 ssa_3 = fadd ssa_1, ssa_2\n",
    cost);
  ASSERT_TRUE(cost.printed);
  EXPECT_EQ(cost.printed->instructions, 2);
  EXPECT_EQ(cost.printed->fetches, 1);
  EXPECT_EQ(cost.printed->inputs, 23);
}

TEST(InstructionCount, IsUnknownIfTheDriverPrintsNothing)
{
  ProgramCost cost;
  CountInstructions("", cost);
  EXPECT_FALSE(cost.printed);
}
