// Shading damped where the gradient is small.

#include "Module/Scenes/ReferenceMaterials.h"

#include <gtest/gtest.h>

using namespace varimarch;

class DampingBy : public testing::TestWithParam<double>
{
};

TEST_P(DampingBy, LeavesThePartOfTheLightThatTheGradientIs)
{
  MapperScene scene(SmallTorso(), 32);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetErrorTolerance(1.0 / 128.0);
  scene.mapper->SetDampingGradient(GetParam());
  const ImageError error = scene.ErrorOf(DampedMaterial(scene));
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.percentile999, 3.0);
}

INSTANTIATE_TEST_SUITE_P(Gradients, DampingBy, testing::Values(50.0, 400.0));

TEST(Damping, ChangesAndCostsNothingWhenOff)
{
  MapperScene scene(SmallTorso(), 24);
  scene.volume->GetProperty()->ShadeOn();
  const std::vector<float> lit = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Damping/None.glsl"));
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  scene.mapper->SetDampingGradient(300.0);
  EXPECT_NE(scene.Draw(), lit);
  EXPECT_TRUE(scene.UsesShaderPart("Damping/Homogeneous.glsl"));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
  scene.mapper->SetDampingGradient(0.0);
  EXPECT_EQ(scene.Draw(), lit);
}
