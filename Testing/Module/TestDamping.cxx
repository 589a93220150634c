// Shading damped where the gradient is small.

#include "Frame/PropertyTransferFunction.h"
#include "Module/MapperScene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

class DampingBy : public testing::TestWithParam<double>
{
};

TEST_P(DampingBy, LeavesThePartOfTheLightThatTheGradientIs)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  MapperScene scene(torso, 32);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetErrorTolerance(1.0 / 128.0);
  const double least = GetParam();
  scene.mapper->SetDampingGradient(least);

  const VolumeGeometry geometry = VolumeGeometryOf(torso, scene.volume);
  const ScalarGrid<short> grid(
    static_cast<const short*>(torso->GetScalarPointer()), geometry.dimensions);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  const glm::dvec3 spacing(torso->GetSpacing()[0], torso->GetSpacing()[1], torso->GetSpacing()[2]);
  const double mean = (spacing.x + spacing.y + spacing.z) / 3.0;
  const auto material = [&](glm::dvec3 positionGrid, const Ray& rayGrid) -> OpticalProperties
  {
    const double value = grid.Value(positionGrid);
    const glm::dvec3 gradient = grid.Gradient(positionGrid); // per voxel
    const double part = std::min(mean * glm::length(gradient / spacing) / least, 1.0);
    const glm::dvec3 normal = glm::normalize(geometry.WorldFromGridNormal() * gradient);
    const glm::dvec3 toEye = glm::normalize(geometry.WorldFromGridDirection() * rayGrid.direction);
    const double facing = std::abs(glm::dot(normal, toEye));
    return { function.Color(value) * (0.1 + part * 0.7 * facing) +
        part * 0.2 * std::pow(facing, 10.0),
      function.Extinction(value) };
  };
  const ImageError error = scene.ErrorOf(material);
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
