// Slicer's volume properties: files are written and read back, cleaned if irregular, and explained
// if broken.

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFormats/LookFormats.h"
#include "Scene/Looks/Presets.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

const LookContext Context = { -1000.0, 3000.0, 2.0 };
const std::string Head = "1\n1\n0.9\n0.1\n0.2\n10\n";
const std::string Tail = "4 0 1 255 1\n8 -100 0 0 0 300 1 0.5 0.25\n";

std::string ProblemOf(const std::string& text)
{
  try
  {
    LookFromSlicerText(text, "bone.vp", LookContext());
  }
  catch (const std::runtime_error& problem)
  {
    return problem.what();
  }
  return "none";
}

}

TEST(SlicerProperty, IsReadWithDiffuseBeforeAmbient)
{
  const Look look =
    LookFromSlicerText(Head + "4 150 0 1500 0.75\n" + Tail, "folder/bone.vp", Context);
  EXPECT_EQ(look.name, "bone");
  EXPECT_EQ(look.domain, Domain::Data);
  EXPECT_TRUE(look.shading.enabled);
  EXPECT_EQ(look.shading.diffuse, 0.9);
  EXPECT_EQ(look.shading.ambient, 0.1);
  EXPECT_EQ(look.shading.specular, 0.2);
  EXPECT_EQ(look.shading.specularPower, 10.0);
  ASSERT_EQ(look.opacities.size(), 2u);
  EXPECT_EQ(look.opacities[1].value, 1500.0);
  EXPECT_EQ(look.opacities[1].opacity, 0.75);
  ASSERT_EQ(look.colors.size(), 2u);
  EXPECT_EQ(look.colors[1].rgb, glm::dvec3(1.0, 0.5, 0.25));
}

TEST(SlicerProperty, KeepsEveryCtPreset)
{
  for (const std::string name : { "ct-bone", "ct-lung", "ct-soft-tissue", "ct-vessels" })
  {
    Look look = BuiltInPreset(name).look;
    const Look back = LookFromSlicerText(SlicerText(look, Context), name + ".vp", Context);
    look.description.clear();
    look.domain = Domain::Data; // a file of Slicer names no unit of values
    look.lengths = Lengths::Millimetres;
    EXPECT_EQ(LookText(back), LookText(look));
  }
}

// Slicer's gradients are per mean spacing, which is 2 mm here.
TEST(SlicerProperty, HasGradientOpacityPerSpacing)
{
  const std::string text = Head + "2 150 0\n" + "4 20 0.1 80 1\n8 0 0 0 0 1 1 1 1\n";
  const Look look = LookFromSlicerText(text, "x", Context);
  ASSERT_EQ(look.gradientOpacities.size(), 2u);
  EXPECT_EQ(look.gradientOpacities[0].value, 10.0);
  EXPECT_EQ(look.gradientOpacities[0].opacity, 0.1);
  EXPECT_NE(SlicerText(look, Context).find("\n4 20 0.1"), std::string::npos);
}

TEST(SlicerProperty, KeepsLooksInJson)
{
  Look look = BuiltInPreset("ct-bone").look;
  look.description.clear();
  look.domain = Domain::Data;
  look.lengths = Lengths::Millimetres;
  look.gradientOpacities = { { 3.0, 0.25, { 0.25, 0.5 } }, { 40.0, 1.0 } };
  look.opacities[1].shape = { 0.25, 0.75 };
  look.colors[1].shape = { 0.75, 0.5 };
  look.isosurfaces = { { 300.0, look.colors[1].rgb, look.opacities[1].opacity } };
  const std::string text = SlicerJson(look, Context);
  const Look back =
    LookFromSlicerJson(nlohmann::json::parse(text), "folder/ct-bone.vp.json", Context);
  EXPECT_EQ(LookText(back), LookText(look));
}

TEST(SlicerProperty, IsSortedAndClampedToItsRanges)
{
  const Look look =
    LookFromSlicerText(Head + "8 300 1.5 100 -1 200 0.25 200 0.75\n" + Tail, "x", Context);
  ASSERT_EQ(look.opacities.size(), 4u);
  EXPECT_EQ(look.opacities[0].value, 100.0);
  EXPECT_EQ(look.opacities[0].opacity, 0.0);
  EXPECT_EQ(look.opacities[1].opacity, 0.25);
  EXPECT_EQ(look.opacities[2].opacity, 0.75);
  EXPECT_EQ(look.opacities[3].opacity, 1.0);
}

TEST(SlicerProperty, BrokenTextIsExplained)
{
  EXPECT_EQ(ProblemOf("1\n1\nmuch\n"),
    "Cannot read bone.vp: expected numbers for the diffuse coefficient, found \"much\".");
  EXPECT_EQ(ProblemOf(Head + "6 150 0 1500 0.75\n" + Tail),
    "Cannot read bone.vp: the scalar opacity promises 6 numbers, 2 for each node, the line holds "
    "4.");
  EXPECT_NE(ProblemOf(Head + "0\n" + Tail), "none");
  EXPECT_NE(ProblemOf(Head + "3 1 2 3\n" + Tail), "none");
  EXPECT_NE(ProblemOf(Head + "2 nan 1\n" + Tail), "none");
  EXPECT_NE(ProblemOf(""), "none");
}
