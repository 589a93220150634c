// Opacity that depends on the gradient, compared with closed forms if the gradient is known, and
// with the reference otherwise.

#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/MapperScene.h"

#include <vtkDataArray.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// A white block of 9 x 9 x 33 voxels whose values rise by `slope` per voxel along x, seen along z.
// Apart from the outermost voxels, it has one gradient.
class Ramp
{
public:
  explicit Ramp(double slope, double zSpacing = 1.0)
    : scene(Values(slope, zSpacing), 17)
  {
    this->scene.colors->RemoveAllPoints();
    this->scene.colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, 0.9);
    vtkCamera* camera = this->scene.renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetFocalPoint(4.0, 4.0, 0.0);
    camera->SetPosition(4.0, 4.0, 1000.0);
    camera->SetClippingRange(1.0, 2000.0);
    this->scene.volume->GetProperty()->SetGradientOpacity(this->factors);
  }

  double DrawnOpacity() { return this->scene.MiddlePixel()[3]; }

  MapperScene scene;
  vtkNew<vtkPiecewiseFunction> factors;

private:
  static vtkSmartPointer<vtkImageData> Values(double slope, double zSpacing)
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, 33);
    image->SetSpacing(1.0, 1.0, zSpacing);
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* voxels = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < 9 * 9 * 33; ++i)
    {
      voxels[i] = float(slope * (i % 9));
    }
    voxels[0] = 100.0f; // keeps the slopes below a quarter of the range
    return image;
  }
};

}

TEST(GradientOpacity, MultipliesTheOpacityOfAUnitDistanceWhateverTheStep)
{
  Ramp ramp(2.0);
  ramp.factors->AddPoint(0.0, 0.0);
  ramp.factors->AddPoint(1.0, 0.01);
  ramp.factors->AddPoint(3.0, 0.03);
  const double expected = 1.0 - std::pow(1.0 - 0.9 * 0.02, 32.0);
  ramp.scene.mapper->AutoAdjustSampleDistancesOff();
  for (const double sampleDistance : { 4.0, 1.0, 0.1 })
  {
    ramp.scene.mapper->SetSampleDistance(sampleDistance);
    EXPECT_NEAR(ramp.DrawnOpacity(), expected, HalfByteStep) << sampleDistance;
  }
}

TEST(GradientOpacity, MeasuresGradientsPerMeanSpacingAsVtkDoes)
{
  // The mean spacing is 2, so the gradient is twice the difference of neighbours along x.
  Ramp ramp(2.0, 4.0);
  ramp.factors->AddPoint(3.9, 0.0);
  ramp.factors->AddPoint(4.0, 0.02);
  ramp.factors->AddPoint(4.1, 0.0);
  const double expected = 1.0 - std::pow(1.0 - 0.9 * 0.02, 4.0 * 32.0);
  EXPECT_NEAR(ramp.DrawnOpacity(), expected, 0.02) << "its peak is narrow";
}

TEST(GradientOpacity, BeyondAQuarterOfTheRangeIsThatOfAQuarter)
{
  // The range is 320; with a mean spacing of 6 the gradient is 240.
  Ramp ramp(40.0, 16.0);
  ramp.factors->AddPoint(0.0, 0.0);
  ramp.factors->AddPoint(80.0, 0.001);
  ramp.factors->AddPoint(240.0, 0.9);
  const double expected = 1.0 - std::pow(1.0 - 0.9 * 0.001, 16.0 * 32.0);
  EXPECT_NEAR(ramp.DrawnOpacity(), expected, HalfByteStep);
}

TEST(GradientOpacity, LeavesAnOpaqueMaterialOpaqueWhereItIsOne)
{
  Ramp ramp(2.0);
  ramp.scene.opacities->AddPoint(0.0, 1.0);
  ramp.factors->AddPoint(0.0, 1.0);
  EXPECT_NEAR(ramp.DrawnOpacity(), 1.0, 1e-6);
  ramp.factors->AddPoint(0.0, 0.0);
  EXPECT_EQ(ramp.DrawnOpacity(), 0.0);
}

class GradientOpacityOfTorso : public testing::TestWithParam<bool>
{
};

TEST_P(GradientOpacityOfTorso, IsThatOfTheReference)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  MapperScene scene(torso, 48);
  const bool shaded = GetParam();
  vtkVolumeProperty* property = scene.volume->GetProperty();
  property->SetShade(shaded);
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.1);
  factors->AddPoint(150.0, 1.0);
  property->SetGradientOpacity(factors);

  const VolumeGeometry geometry = VolumeGeometryOf(torso, scene.volume);
  const ScalarGrid<short> grid(
    static_cast<const short*>(torso->GetScalarPointer()), geometry.dimensions);
  double spacing[3];
  torso->GetSpacing(spacing);
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  double range[2];
  torso->GetScalarRange(range);
  const auto material = [&](glm::dvec3 positionGrid, const Ray& rayGrid) -> OpticalProperties
  {
    const double value = grid.Value(positionGrid);
    const glm::dvec3 gradient = grid.Gradient(positionGrid); // per voxel
    const double magnitude = std::min(0.25 * (range[1] - range[0]),
      mean * glm::length(gradient / glm::dvec3(spacing[0], spacing[1], spacing[2])));
    const double factor = 0.1 + 0.9 * std::min(magnitude, 150.0) / 150.0;
    double color[3];
    scene.colors->GetColor(value, color);
    const glm::dvec3 normal = glm::normalize(geometry.WorldFromGridNormal() * gradient);
    const glm::dvec3 toEye = glm::normalize(geometry.WorldFromGridDirection() * rayGrid.direction);
    const double facing = std::abs(glm::dot(normal, toEye));
    const glm::dvec3 rgb(color[0], color[1], color[2]);
    return { shaded ? rgb * (0.1 + 0.7 * facing) + 0.2 * std::pow(facing, 10.0) : rgb,
      -std::log1p(-scene.opacities->GetValue(value) * factor) };
  };
  const ImageError error = scene.ErrorOf(material);
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 10.0);
}

namespace
{

// Waves of values from 0.1 to 0.9, with one other voxel.
vtkSmartPointer<vtkImageData> WavesWith(double fill)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(12, 12, 12);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxels = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 12 * 12 * 12; ++i)
  {
    const double z = i / 144 * 0.3;
    voxels[i] = float(0.5 + 0.4 * std::sin(i % 12 * 0.7) * std::cos(i / 12 % 12 * 0.5 + z));
  }
  voxels[11] = float(fill);
  return image;
}

// The waves with gradients from a value on, seen away from the other voxel.
std::vector<float> WavesByGradients(double fill, double gradient, bool byProcessor)
{
  MapperScene scene(WavesWith(fill), 32);
  scene.LookDown({ 4.0, 6.0, 5.5 }, 3.5);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 0.9, 0.6, 0.4);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.1, 0.02);
  scene.opacities->AddPoint(0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AllowDuplicateScalarsOn();
  factors->AddPoint(0.0, 0.0);
  factors->AddPoint(gradient, 0.0);
  factors->AddPoint(gradient, 1.0);
  factors->AddPoint(gradient + 0.4, 1.0);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
  return byProcessor ? scene.DrawByProcessor() : scene.Draw();
}

}

TEST(GradientOpacity, StepsWhereItDoesHoweverFarOneVoxelIs)
{
  for (const bool byProcessor : { false, true })
  {
    for (const double gradient : { 0.12, 0.0 })
    {
      const std::vector<float> plain = WavesByGradients(0.5, gradient, byProcessor);
      ASSERT_GT(*std::max_element(plain.begin(), plain.end()), 0.1f);
      for (const double fill : { -32768.0, -1e6, -1e20, 1e30, double(INFINITY), double(NAN) })
      {
        const std::vector<float> picture = WavesByGradients(fill, gradient, byProcessor);
        const ImageError error = CompareImages(picture.data(), plain.data(), plain.size() / 4);
        EXPECT_LT(error.largest, 4.0) << fill << ", gradient " << gradient;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ShadedOrNot, GradientOpacityOfTorso, testing::Values(false, true));

TEST(GradientOpacity, TakesItsShaderAndTableOnlyWhereItIs)
{
  MapperScene scene(SmallTorso(), 16);
  scene.Draw();
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 0.5);
  scene.volume->GetProperty()->SetGradientOpacity(factors);
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Shade/None.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("GradientOpacity/Table.glsl"));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes + 4096 * 16);
  scene.volume->GetProperty()->SetDisableGradientOpacity(1);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
}
