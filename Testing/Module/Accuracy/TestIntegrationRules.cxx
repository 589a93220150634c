// Convergence of each integration rule to the reference with shrinking sample distance.

#include "Module/Scenes/MapperScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

constexpr double LengthMm = 32.0;

// Values that rise evenly from 0 to 1000 along x, and are therefore linear along every ray.
vtkSmartPointer<vtkImageData> Ramp(int voxels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(voxels, 3, 3);
  image->SetSpacing(LengthMm / (voxels - 1), 8.0, 8.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* scalars = static_cast<short*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    scalars[i] = short(1000 * (i % voxels) / (voxels - 1));
  }
  return image;
}

// Rays along x through the ramp. Extinction and colour are smooth, and not 0 at the ends.
class RampScene : public MapperScene
{
public:
  explicit RampScene(int voxels, bool shaded = false)
    : MapperScene(Ramp(voxels), 8)
  {
    this->volume->GetProperty()->SetShade(shaded);
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(0.0, 1.0, 0.2, 0.0);
    this->colors->AddRGBPoint(1000.0, 0.0, 0.4, 1.0);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.0, 0.03);
    this->opacities->AddPoint(1000.0, 0.25);
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(16.0, 8.0, 8.0);
    camera->SetPosition(-100.0, 8.0, 8.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(6.0);
    camera->SetClippingRange(1.0, 1000.0);
    this->mapper->AutoAdjustSampleDistancesOff();
    this->mapper->SetEarlyTerminationTransmittance(0.0);
    this->truth = this->Truth(1e-10);
  }

  // Largest error of a channel with the given number of samples along the ramp.
  double ErrorOf(int samples)
  {
    this->mapper->SetSampleDistance(LengthMm / samples);
    const std::vector<float> drawn = this->Draw();
    return varimarch::CompareImages(drawn.data(), this->truth.data(), drawn.size() / 4).largest /
      255.0;
  }

private:
  std::vector<float> truth;
};

struct RuleOrder
{
  int rule;
  int samples; ///< few enough that halving their distance stays above the rounding of floats
  double order;
  bool shaded = false;
};

}

class IntegrationRule : public testing::TestWithParam<RuleOrder>
{
};

TEST_P(IntegrationRule, ConvergesAsTheoryHasIt)
{
  RampScene scene(2, GetParam().shaded);
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetIntegrationRule(GetParam().rule);
  const int samples = GetParam().samples;
  const double coarse = scene.ErrorOf(samples);
  const double fine = scene.ErrorOf(4 * samples);
  EXPECT_GT(fine, 3e-7) << "nothing is left to measure";
  EXPECT_NEAR(0.5 * std::log2(coarse / fine), GetParam().order, 0.25) << coarse << " " << fine;
}

TEST_P(IntegrationRule, ConvergesAlikeWithTheOpticalField)
{
  RampScene scene(33, GetParam().shaded);
  scene.mapper->SetIntegrationRule(GetParam().rule);
  const int samples = 4 * GetParam().samples;
  scene.mapper->SetAccelerationModeToOff();
  const double without = scene.ErrorOf(samples);
  scene.mapper->SetAccelerationModeToOpticalField();
  // Behind absorbing material, steps grow by up to 4, and the sum of errors by less than that.
  EXPECT_LT(scene.ErrorOf(samples), 4.0 * without + 1.0 / 255.0);
}

INSTANTIATE_TEST_SUITE_P(Every, IntegrationRule,
  testing::Values(RuleOrder{ Mapper::Midpoint, 8, 2.0 }, RuleOrder{ Mapper::PreIntegrated, 8, 2.0 },
    RuleOrder{ Mapper::Simpson, 4, 4.0 }, RuleOrder{ Mapper::PublishedSum, 32, 1.0 },
    RuleOrder{ Mapper::Midpoint, 8, 2.0, true }, RuleOrder{ Mapper::PreIntegrated, 8, 2.0, true }));

TEST(IntegrationRules, PreIntegrationMissesNoPeakBetweenTwoSamples)
{
  RampScene scene(2);
  scene.mapper->SetAccelerationModeToOff();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(400.0, 0.0);
  scene.opacities->AddPoint(410.0, 0.5);
  scene.opacities->AddPoint(420.0, 0.0);
  const auto opacityWith = [&](int rule)
  {
    scene.mapper->SetIntegrationRule(rule);
    scene.mapper->SetSampleDistance(LengthMm / 4.0);
    return scene.Draw()[4 * (8 * 4 + 4) + 3];
  };
  const float truth = scene.Truth()[4 * (8 * 4 + 4) + 3];
  EXPECT_GT(truth, 0.1f);
  EXPECT_NEAR(opacityWith(Mapper::PreIntegrated), truth, 0.01f);
  EXPECT_EQ(opacityWith(Mapper::Midpoint), 0.0f) << "the samples should miss the peak";
}
