// Averages of a range of values, compared with the reference: no part of a ray in the range is
// missed, however short.

#include "Module/Scenes/MapperScene.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

// Values from 0 to 200 without any order.
vtkSmartPointer<vtkImageData> NoiseOfBytes()
{
  constexpr int Side = 9;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::mt19937 random(3);
  std::generate_n(voxels, Side * Side * Side, [&] { return (unsigned char)(random() % 201); });
  return image;
}

// An average of the range, drawn by both marchers.
class RangeMean : public testing::Test
{
protected:
  RangeMean()
    : scene(NoiseOfBytes(), 56)
  {
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.0, 0.2);
    this->scene.opacities->AddPoint(200.0, 0.9);
    this->scene.mapper->SetBlendModeToAverageIntensity();
    this->scene.mapper->SetErrorTolerance(1.0 / 64.0);
  }

  // A pixel may differ where a ray touches the range by less than floats tell.
  void ExpectTruth(double lower, double upper)
  {
    this->scene.mapper->SetAverageIPScalarRange(lower, upper);
    const std::vector<float> truth = this->scene.Truth(1e-4);
    for (const WayToDraw draw : WaysToDraw())
    {
      const std::vector<float> drawn = (this->scene.*draw)();
      const ImageError error = CompareImages(drawn.data(), truth.data(), truth.size() / 4);
      EXPECT_LT(error.largest, 2.0 * 255.0 / 64.0) << lower << " to " << upper;
      EXPECT_LT(error.percentile999, 255.0 / 64.0) << lower << " to " << upper;
    }
  }

  MapperScene scene;
};

}

TEST_F(RangeMean, MissesNoValuesAboveAll)
{
  this->ExpectTruth(185.0, 1000.0);
}

TEST_F(RangeMean, MissesNoValuesBelowAll)
{
  this->ExpectTruth(-1000.0, 15.0);
}

TEST_F(RangeMean, MissesNoThinRange)
{
  this->ExpectTruth(100.0, 100.5);
}

TEST_F(RangeMean, CountsTheEndsOfTheRange)
{
  // All voxels of one value, which is an end of the range.
  auto* const voxels = static_cast<unsigned char*>(this->scene.image->GetScalarPointer());
  std::fill_n(voxels, 9 * 9 * 9, (unsigned char)(77));
  voxels[0] = 0;
  voxels[1] = 200;
  this->scene.image->Modified();
  this->ExpectTruth(77.0, 90.0);
  this->ExpectTruth(60.0, 77.0);
}

TEST_F(RangeMean, IsDividedByCutsAndMissesNothing)
{
  this->scene.mapper->CroppingOn();
  this->scene.mapper->SetCroppingRegionPlanes(2.3, 5.7, 2.2, 5.9, 2.4, 6.1);
  this->scene.mapper->SetCroppingRegionFlags(VTK_CROP_INVERTED_FENCE);
  this->scene.mapper->SetAverageIPScalarRange(185.0, 1000.0);
  const std::vector<float> drawn = this->scene.Draw();
  const std::vector<float> marched = this->scene.DrawByProcessor();
  EXPECT_LT(CompareImages(drawn.data(), marched.data(), drawn.size() / 4).largest, 0.5);
}
