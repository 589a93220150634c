// Spline interpolation of voxels, compared with a spline in double precision.

#include "Core/Geometry/PixelRays.h"
#include "Module/Scenes/CubicScene.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace varimarch;

class CubicOfTypes : public testing::TestWithParam<int>
{
};

TEST_P(CubicOfTypes, IsTheSplineThroughTheVoxels)
{
  CubicScene scene(NoisyEdge(GetParam()));
  scene.mapper->SetErrorTolerance(1.0 / 256.0);
  const ImageError error = scene.ErrorOf(scene.Truth());
  EXPECT_LT(error.percentile999, 1.0);
  EXPECT_LT(error.largest, 2.0);
}

INSTANTIATE_TEST_SUITE_P(
  Types, CubicOfTypes, testing::Values(VTK_UNSIGNED_CHAR + 0, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE));

TEST(Cubic, IsLitByTheGradientOfTheSpline)
{
  CubicScene scene(NoisyEdge(VTK_SHORT));
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetErrorTolerance(1.0 / 256.0);
  const ImageError error = scene.ErrorOf(scene.Truth());
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.percentile999, 2.0);
}

class CubicFields : public testing::TestWithParam<int>
{
};

TEST_P(CubicFields, NeverJumpOverWhatTheSplineShows)
{
  // One plane of nonzero coefficients lies behind the face of a brick and of a cell. In front of it
  // the spline is visible although all coefficients there are 0.
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(33, 30, 28);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* const voxels = static_cast<short*>(image->GetScalarPointer());
  std::fill_n(voxels, 33 * 30 * 28, short(0));
  for (int i = 0; i < 30 * 28; ++i)
  {
    voxels[33 * i + 8] = 100;
    voxels[33 * i + 9] = 400;
    voxels[33 * i + 10] = 100;
  }
  CubicScene scene(image, 32);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(1.0, 0.0);
  scene.opacities->AddPoint(100.0, 0.5);
  scene.mapper->SetAccelerationMode(GetParam());
  scene.mapper->SetVariationTolerance(0.5);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.05);
  const ImageError error = scene.ErrorOf(scene.Truth());
  EXPECT_LT(error.largest, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Fields, CubicFields,
  testing::Values(
    vtkVariationFieldVolumeMapper::CellField + 0, vtkVariationFieldVolumeMapper::OpticalField));

TEST(Cubic, MeetsWithoutASeamBetweenBlocks)
{
  CubicScene scene(ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 7 }));
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1100.0, 0.001);
  scene.opacities->AddPoint(1100.0, 0.05);
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.2);
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetMaximumGraphicsMemory(680000);
  const std::vector<float> inBlocks = scene.Draw();
  ASSERT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
  EXPECT_LT(CompareImages(inBlocks.data(), whole.data(), whole.size() / 4).largest, 1.0);
}

TEST(Cubic, MaximumIsTheLargestValueOfTheSpline)
{
  CubicScene scene(NoisyEdge(VTK_SHORT), 24);
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(400.0, 1.0);
  scene.mapper->SetErrorTolerance(1.0 / 256.0);
  const std::vector<float> drawn = scene.Draw();
  const VolumeGeometry geometry = VolumeGeometryOf(scene.image, scene.volume);
  const PixelRays rays =
    ComputePixelRays(ClipFromWorld(scene.renderer) * geometry.worldFromGrid, geometry.boxGrid);
  bool goesBeyondTheVoxels = false;
  for (int pixel = 0; pixel < 24 * 24; ++pixel)
  {
    const Ray ray =
      rays.At(2.0 * (pixel % 24 + 0.5) / 24 - 1.0, 2.0 * (pixel / 24 + 0.5) / 24 - 1.0);
    const Interval inside = Intersection(ray, geometry.boxGrid, rays.BetweenPlanes(ray));
    double largest = 0.0;
    for (int i = 0; i <= 2000 && !inside.IsEmpty(); ++i)
    {
      const double t = inside.enter + (inside.exit - inside.enter) * i / 2000;
      largest = std::max(largest, scene.spline.Value(ray.origin + t * ray.direction));
    }
    EXPECT_NEAR(drawn[4 * pixel + 3], std::min(largest / 400.0, 1.0), 1.5 / 256.0) << pixel;
    goesBeyondTheVoxels = goesBeyondTheVoxels || largest > scene.image->GetScalarRange()[1];
  }
  EXPECT_TRUE(goesBeyondTheVoxels) << "otherwise the range of the voxels would suffice";
}

TEST(Cubic, TakesItsShaderAndMemoryOnlyWhereItIsOn)
{
  CubicScene scene(NoisyEdge(VTK_SHORT), 16);
  scene.mapper->CubicInterpolationOff();
  const std::vector<float> linear = scene.Draw();
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  scene.mapper->CubicInterpolationOn();
  EXPECT_NE(scene.Draw(), linear);
  EXPECT_TRUE(scene.UsesShaderPart("Interpolation/CubicSpline.glsl"));
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 2) << "it is kept from frame to frame";
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  const std::vector<float> nearest = scene.Draw();
  scene.mapper->CubicInterpolationOff();
  EXPECT_EQ(scene.Draw(), nearest) << "voxels as boxes are not interpolated at all";
  scene.volume->GetProperty()->SetInterpolationTypeToLinear();
  EXPECT_EQ(scene.Draw(), linear);
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes);
}

TEST(Cubic, GoesOnWithTheValueOfTheFaceBeyondTheMiddlesOfCells)
{
  // Cell data extend half a voxel beyond the outermost centres, with the value of the face.
  const auto points = NoisyEdge(VTK_SHORT);
  const auto cells = vtkSmartPointer<vtkImageData>::New();
  cells->SetDimensions(15, 12, 10);
  cells->SetSpacing(points->GetSpacing());
  cells->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  MapperScene scene(cells, 24);
  scene.mapper->CubicInterpolationOn();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.001);
  scene.opacities->AddPoint(300.0, 0.2);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.02);
  const SplineGrid spline = SplineOf(points);
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  const auto truth = [&](glm::dvec3 position, const Ray&)
  {
    const double value = spline.Value(position);
    return OpticalProperties{ function.Color(value), function.Extinction(value) };
  };
  EXPECT_LT(scene.ErrorOf(truth).largest, 1.0);
}

TEST(Cubic, SaysWhatItCannotInterpolate)
{
  const auto image = NoisyEdge(VTK_FLOAT);
  image->GetPointData()->GetScalars()->SetComponent(700, 0, NAN);
  CubicScene scene(image, 16);
  ExpectedVtkErrors expected;
  scene.window->Render();
  EXPECT_TRUE(expected.Text().find("voxels that are not finite") != std::string::npos);
}
