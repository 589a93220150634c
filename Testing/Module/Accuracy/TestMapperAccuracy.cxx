// Images of the mapper against the reference integrator, which is in double precision and shares no
// formula.

#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// Half of 1/255, which is invisible; no pixel may exceed it.
void ExpectInvisibleError(MapperScene& scene)
{
  const varimarch::ImageError error = scene.Error();
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.percentile999, 6.0);
  EXPECT_LT(error.largest, 10.0);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.5) << "the image is empty";
}

// Makes air invisible, which fills most bricks around and in the torso.
void SetAirAndTissue(MapperScene& scene)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-400.0, 0.0);
  scene.opacities->AddPoint(-100.0, 0.05);
}

}

class MapperAccuracy : public testing::TestWithParam<int>
{
};

TEST_P(MapperAccuracy, CompositeIsWithinHalfAGreyLevelOfTheTruth)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetAccelerationMode(GetParam());
  ExpectInvisibleError(scene);
}

TEST_P(MapperAccuracy, ShadedCompositeIsWithinHalfAGreyLevelOfTheTruth)
{
  MapperScene scene(SmallTorso());
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetAccelerationMode(GetParam());
  ExpectInvisibleError(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryField, MapperAccuracy,
  testing::Values(int(Mapper::Off), int(Mapper::CellField), int(Mapper::OpticalField)));

class ExtremeAccuracy : public testing::TestWithParam<int>
{
};

TEST_P(ExtremeAccuracy, IsTheTruthWhateverBricksAreLeftAndWhateverTheSampleDistance)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetBlendMode(GetParam());
  // The smallest value is that of air, which must be opaque to be visible.
  scene.opacities->AddPoint(-1100.0, 0.9);
  const std::vector<float> truth = scene.Truth();
  EXPECT_GT(*std::max_element(truth.begin(), truth.end()), 0.5) << "the image is empty";
  const auto largestError = [&]
  {
    const std::vector<float> drawn = scene.Draw();
    return varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4).largest;
  };
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(50.0);
  scene.mapper->SetAccelerationModeToOff();
  EXPECT_LT(largestError(), 0.1);
  scene.mapper->AutoAdjustSampleDistancesOn();
  scene.mapper->SetAccelerationModeToOpticalField();
  for (double tolerance : { 1.0 / 16.0, 1.0 / 255.0 })
  {
    scene.mapper->SetErrorTolerance(tolerance);
    EXPECT_LT(largestError(), 255.0 * tolerance / 8.0 + 0.1) << "the field has an eighth of it";
  }
  EXPECT_TRUE(scene.UsesShaderPart("Step/BrickExtremes.glsl"));
}

INSTANTIATE_TEST_SUITE_P(MaximumAndMinimum, ExtremeAccuracy,
  testing::Values(
    int(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND), int(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND)));

TEST(Mapper, AverageIntensityIsCloseToTheTruth)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetBlendModeToAverageIntensity();
  scene.opacities->AddPoint(0.0, 0.8);
  EXPECT_LT(scene.Error().rootMeanSquare, 0.5);
  const double all = scene.Draw()[4 * (48 * 96 + 48)];
  scene.mapper->SetAverageIPScalarRange(-50.0, 150.0);
  // A ray that is in the range for less than a step is either transparent or the value of its
  // sample.
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(2.0);
  const double coarse = scene.Error().rootMeanSquare;
  scene.mapper->SetSampleDistance(0.1);
  EXPECT_LT(scene.Error().rootMeanSquare, 0.4 * coarse) << coarse;
  EXPECT_NE(scene.Draw()[4 * (48 * 96 + 48)], all);
}

TEST(Mapper, AdditiveIsCloseToTheTruth)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetBlendModeToAdditive();
  EXPECT_LT(scene.Error().rootMeanSquare, 1.0);
  scene.volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  EXPECT_LT(scene.Error().rootMeanSquare, 1.0) << "where it is white";
}

// The centre of the image lies between two bright voxels at opposite corners.
TEST(Mapper, ARayWithoutVisibleVoxelsFetchesNothing)
{
  constexpr int Side = 33;
  vtkNew<vtkImageData> image;
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), Side * Side * Side, 0);
  image->SetScalarComponentFromDouble(2, 2, 2, 0, 100.0);
  image->SetScalarComponentFromDouble(30, 30, 30, 0, 100.0);
  MapperScene scene(image, 33);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(50.0, 0.0);
  scene.opacities->AddPoint(100.0, 1.0);
  scene.mapper->SetAccelerationModeToOpticalField();
  scene.mapper->DrawFetchCountsOn();
  const std::vector<float> counts = scene.Draw();
  EXPECT_GT(*std::max_element(counts.begin(), counts.end()), 2.0f);
  EXPECT_EQ(counts[4 * (16 * 33 + 16)], 0.0f);
}

TEST(Mapper, SumsAndAveragesLeaveInvisibleBricksOutAndCountTheirLength)
{
  MapperScene scene(SmallTorso());
  SetAirAndTissue(scene);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.1);
  const auto leavesOut = [&] { return scene.UsesShaderPart("Step/OpticalField.glsl"); };
  for (int blend : { vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    scene.mapper->SetBlendMode(blend);
    EXPECT_LT(scene.Error().largest, 0.5) << blend;
    EXPECT_TRUE(leavesOut());
  }
  // Lengths outside the range must not count.
  scene.mapper->SetBlendModeToAverageIntensity();
  scene.mapper->SetAverageIPScalarRange(-500.0, 3000.0);
  EXPECT_LT(scene.Error().percentile999, 5.0);
  EXPECT_FALSE(leavesOut());
}

TEST(Mapper, LightOnABrickOfOneLookIsNotTakenAsTheSameEverywhere)
{
  // Bone with one opacity and colour for all values: homogeneous except for its light.
  MapperScene scene(SmallTorso());
  scene.volume->GetProperty()->ShadeOn();
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 1.0, 0.9, 0.8);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-900.0, 0.0);
  scene.opacities->AddPoint(-500.0, 0.02);
  scene.opacities->AddPoint(2000.0, 0.02);
  scene.mapper->SetAccelerationModeToOpticalField();
  ExpectInvisibleError(scene);
}

TEST(Mapper, ParallelProjectionIsWithinHalfAGreyLevelOfTheTruth)
{
  MapperScene scene(SmallTorso());
  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  ExpectInvisibleError(scene);
}

TEST(Mapper, CameraInsideTheVolumeIsWithinHalfAGreyLevelOfTheTruth)
{
  MapperScene scene(SmallTorso());
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(5.0, -20.0, 10.0);
  camera->SetFocalPoint(0.0, 40.0, 0.0);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(1.0, 1000.0);
  ExpectInvisibleError(scene);
}

TEST(Mapper, NearPlaneCutsTheVolumeWhereItShould)
{
  MapperScene scene(SmallTorso());
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  camera->SetClippingRange(distance, 3.0 * distance);
  ExpectInvisibleError(scene);
}

TEST(Mapper, MatricesOfVolumeAndImageAreHonoured)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  // A mirror and a rotation: x points against y, y along x, z backwards.
  const double direction[9] = { 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0 };
  torso->SetDirectionMatrix(direction);
  MapperScene scene(torso);
  scene.volume->SetScale(1.2, 0.8, 1.0);
  scene.volume->RotateWXYZ(35.0, 0.3, 1.0, 0.2);
  scene.volume->GetProperty()->ShadeOn();
  scene.renderer->ResetCamera();
  ExpectInvisibleError(scene);
}

TEST(Mapper, AnExtentThatStartsElsewhereDrawsTheSamePicture)
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  MapperScene scene(torso);
  const std::vector<float> before = scene.Draw();
  int extent[6];
  double origin[3];
  double spacing[3];
  torso->GetExtent(extent);
  torso->GetOrigin(origin);
  torso->GetSpacing(spacing);
  torso->SetExtent(
    extent[0] + 5, extent[1] + 5, extent[2], extent[3], extent[4] - 3, extent[5] - 3);
  torso->SetOrigin(origin[0] - 5 * spacing[0], origin[1], origin[2] + 3 * spacing[2]);
  EXPECT_LT(varimarch::CompareImages(scene.Draw().data(), before.data(), 96 * 96).largest, 0.1);
}

TEST(Mapper, OpaqueGeometryHidesWhatIsBehindIt)
{
  MapperScene scene(SmallTorso());
  vtkNew<vtkSphereSource> source;
  source->SetRadius(400.0);
  source->SetThetaResolution(64);
  source->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(surface);
  wall->SetPosition(0.0, 400.0, 0.0); // its near side passes through the centre of the volume
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(0.0, 0.0, 0.0);

  const std::vector<float> without = scene.Draw();
  scene.renderer->AddActor(wall);
  const std::vector<float> withWall = scene.Draw();
  // Only the front half is visible: darker in some pixels, and brighter in none.
  double lost = 0.0;
  double gained = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < without.size(); i += 4)
  {
    gained = std::max(gained, double(withWall[i]) - without[i]);
    lost = std::max(lost, double(without[i]) - withWall[i]);
    sum += withWall[i];
  }
  EXPECT_LT(gained, 0.01);
  EXPECT_GT(lost, 0.1);
  EXPECT_GT(sum, 1.0) << "all of the volume is hidden";
  // With the wall behind the volume nothing is hidden.
  wall->SetPosition(0.0, 1000.0, 0.0);
  const std::vector<float> behind = scene.Draw();
  double changed = 0.0;
  for (std::size_t i = 0; i < without.size(); i += 4)
  {
    changed = std::max(changed, std::abs(double(behind[i]) - without[i]));
  }
  EXPECT_LT(changed, 0.004);
}

namespace
{

// Visible and invisible regions alternate at other positions in each ray.
vtkSmartPointer<vtkImageData> Noise()
{
  auto noise = vtkSmartPointer<vtkImageData>::New();
  noise->SetDimensions(48, 48, 48);
  noise->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(noise->GetScalarPointer());
  std::mt19937 generator(1);
  std::generate(voxels, voxels + noise->GetNumberOfPoints(), [&] { return generator() % 256; });
  return noise;
}

}

TEST(LitNoise, IsMarchedToTheEndHoweverShortTheSteps)
{
  MapperScene scene(Noise(), 24);
  scene.volume->GetProperty()->ShadeOn();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(120.0, 0.0);
  scene.opacities->AddPoint(255.0, 0.05);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(scene.image->GetLength() / 19000.0);
  const ExpectedVtkErrors itIsTooShort;
  const varimarch::ImageError error = scene.Error();
  EXPECT_LT(error.largest, 2.0);
  EXPECT_FALSE(itIsTooShort.Messages().empty());
}
