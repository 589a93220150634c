// Slices: the patient's sides are where radiologists expect them, and values are interpolated
// between voxels.

#include "Scene/Slices/SlicePicture.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// One voxel is 255, all others are 0. Voxels of 1 mm, the centre one at the world's origin.
vtkSmartPointer<vtkImageData> OneVoxel(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(21, 21, 21);
  image->SetOrigin(-10.0, -10.0, -10.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* const values = static_cast<short*>(image->GetScalarPointer());
  std::fill(values, values + 21 * 21 * 21, short(0));
  *static_cast<short*>(image->GetScalarPointer(x + 10, y + 10, z + 10)) = 255;
  return image;
}

// 21 pixels of 1 mm per side, with the world's origin at the centre pixel.
SliceRequest Request(SlicePlane plane)
{
  return { plane, { 0.0, 0.0, 0.0 }, 1.0, 21, 21, 255.0, 127.5, 0.0 };
}

int Pixel(const std::vector<std::uint8_t>& picture, int right, int down)
{
  return picture[(down + 10) * 21 + right + 10];
}

}

TEST(SlicePicture, PutsThePatientWhereRadiologistsExpect)
{
  // Left, posterior and superior are the world's positive axes.
  const auto left = SlicePicture(OneVoxel(5, 0, 0), Request(SlicePlane::Axial));
  EXPECT_EQ(Pixel(left, 5, 0), 255) << "the patient's left is on the right";
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 5, 0), Request(SlicePlane::Axial)), 0, 5), 255);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(5, 0, 0), Request(SlicePlane::Coronal)), 5, 0), 255);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 5), Request(SlicePlane::Coronal)), 0, -5), 255);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 5, 0), Request(SlicePlane::Sagittal)), 5, 0), 255);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 5), Request(SlicePlane::Sagittal)), 0, -5), 255);
}

TEST(SlicePicture, ShowsAnObliquePlane)
{
  // Turned by 45 degrees about the axis from right to left, an axial plane contains (0, 4, 4).
  const auto image = OneVoxel(0, 4, 4);
  SliceRequest request = Request(SlicePlane::Axial);
  const auto straight = SlicePicture(image, request);
  EXPECT_EQ(*std::max_element(straight.begin(), straight.end()), 0);
  request.turn = { 45.0, 0.0, 0.0 };
  const auto oblique = SlicePicture(image, request);
  const auto brightest = std::max_element(oblique.begin(), oblique.end());
  EXPECT_GT(*brightest, 100);
  EXPECT_EQ((brightest - oblique.begin()) % 21, 10) << "not beside the middle";
  EXPECT_EQ((brightest - oblique.begin()) / 21, 16) << "4 * sqrt(2) below the middle";
}

TEST(SliceAxes, AreTurnedInTheirPlaneAsLittleAsPossible)
{
  const SliceTurn turn = TurnedBy({}, { 0.0, 0.0, 1.0 }, 90.0);
  const SliceAxes axial = AxesOf(SlicePlane::Axial, turn);
  const SliceAxes coronal = AxesOf(SlicePlane::Coronal, turn);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(axial.right[i], AxesOf(SlicePlane::Axial).right[i], 1e-12);
    EXPECT_NEAR(coronal.through[i], -AxesOf(SlicePlane::Sagittal).through[i], 1e-12);
    EXPECT_NEAR(coronal.down[i], AxesOf(SlicePlane::Coronal).down[i], 1e-12);
  }
  // Three right angles about the three axes are one about the second, in closed form.
  const SliceTurn several =
    TurnedBy(TurnedBy(TurnedBy({}, { 1.0, 0.0, 0.0 }, 90.0), { 0.0, 1.0, 0.0 }, 90.0),
      { 0.0, 0.0, 1.0 }, 90.0);
  EXPECT_NEAR(several[0], 0.0, 1e-9);
  EXPECT_NEAR(several[1], 90.0, 1e-9);
  EXPECT_NEAR(several[2], 0.0, 1e-9);
  // Half a turn has a through direction that faces the anatomical one.
  const SliceAxes facing = AxesOf(SlicePlane::Axial, { 180.0, 0.0, 0.0 });
  EXPECT_NEAR(facing.through[2], -1.0, 1e-12);
  EXPECT_NEAR(std::abs(facing.right[0]), 1.0, 1e-12);
}

TEST(SlicePicture, FollowsTheDirectionOfTheImage)
{
  const auto image = OneVoxel(5, 0, 0);
  image->SetDirectionMatrix(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  EXPECT_EQ(Pixel(SlicePicture(image, Request(SlicePlane::Axial)), 0, 5), 255);
}

TEST(SlicePicture, IsLinearBetweenVoxelsAndBlackOutside)
{
  SliceRequest request = Request(SlicePlane::Axial);
  request.middleMm = { 0.5, 0.0, 0.0 };
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 0), request), 0, 0), 128);
  request = Request(SlicePlane::Axial);
  request.level = -1000.0; // the whole volume is white
  request.mmPerPixel = 2.0;
  const auto picture = SlicePicture(OneVoxel(0, 0, 0), request);
  EXPECT_EQ(Pixel(picture, 5, 0), 255);
  EXPECT_EQ(Pixel(picture, 6, 0), 0);
}

TEST(SlicePicture, IsInvertedForPetAndFollowsTheFilesWindow)
{
  LoadedVolume volume;
  volume.image = OneVoxel(0, 0, 0);
  std::fill_n(static_cast<short*>(volume.image->GetScalarPointer()), 2000, short(100)); // below it
  const ImageStatistics statistics(volume.image);
  volume.modality = "PT";
  EXPECT_TRUE(SuggestedGrays(volume, statistics).inverted);
  EXPECT_EQ(SuggestedGrays(volume, statistics).windowLevel, (std::array<double, 2>{ 50.0, 25.0 }))
    << "white is no tracer, black half of the brightest";
  volume.modality = "CT";
  EXPECT_FALSE(SuggestedGrays(volume, statistics).inverted);
  volume.isInverted = true;
  EXPECT_TRUE(SuggestedGrays(volume, statistics).inverted);
  volume.windowLevel = { 400.0, 60.0 };
  EXPECT_EQ(SuggestedGrays(volume, statistics).windowLevel, *volume.windowLevel);

  SliceRequest request = Request(SlicePlane::Axial);
  request.mmPerPixel = 2.0;
  request.inverted = true;
  const auto picture = SlicePicture(volume.image, request);
  EXPECT_EQ(Pixel(picture, 0, 0), 0);
  EXPECT_EQ(Pixel(picture, 4, 0), 255);
  EXPECT_EQ(Pixel(picture, 8, 0), 0) << "outside";
}

TEST(SlicePicture, SlabShowsItsLargestValue)
{
  SliceRequest request = Request(SlicePlane::Axial);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 3), request), 0, 0), 0);
  request.slabMm = 6.0;
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 3), request), 0, 0), 255);
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, -3), request), 0, 0), 255);
}

TEST(SlicePicture, SlabThickerThanTheVolumeShowsAllOfIt)
{
  SliceRequest request = Request(SlicePlane::Axial);
  request.slabMm = 1e300; // sessions may say so
  EXPECT_EQ(Pixel(SlicePicture(OneVoxel(0, 0, 10), request), 0, 0), 255);
}

TEST(SlicePicture, SlabShowsItsLargestSmallestOrMeanValue)
{
  SliceRequest request = Request(SlicePlane::Axial);
  request.slabMm = 4.0; // the slab covers -2 to 2 mm, and the voxel lies at 2 mm
  const auto image = OneVoxel(0, 0, 2);
  const auto middle = [&](SlabBlend blend)
  {
    request.slabBlend = blend;
    return Pixel(SlicePicture(image, request), 0, 0);
  };
  EXPECT_EQ(middle(SlabBlend::Maximum), 255);
  EXPECT_EQ(middle(SlabBlend::Minimum), 0);
  // Nine samples, 0.5 mm apart: the last one is the voxel, the one before it half of its value.
  EXPECT_EQ(middle(SlabBlend::Mean), 43);
}
