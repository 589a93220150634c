#include "Scene/Slices/SliceFusing.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

constexpr int FusedSide = 100; // pixels of 1 mm

// Voxels of 1 mm from 0 to 60 mm, whose value is their x.
vtkSmartPointer<vtkImageData> FusedRamp()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(61, 61, 61);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 61 * 61 * 61; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = std::uint8_t(i % 61);
  }
  return image;
}

// The middle of pixel i is at i + 0.5 mm.
SliceRequest FusedRequest()
{
  return { SlicePlane::Axial, { 50.0, 50.0, 30.0 }, 1.0, FusedSide, FusedSide, 60.0, 30.0, 0.0 };
}

Rgba FusedPixel(const std::vector<Rgba>& pixels, int column, int row)
{
  return pixels[std::size_t(row) * FusedSide + column];
}

}

TEST(SliceFusing, ABlendHasTheColoursOfTheWindowAndEndsAtTheVolume)
{
  const auto pixels =
    FusedPixels(FusedRamp(), FusedRequest(), { SliceColors::Hot, 0.5, SliceFusion::Blend });
  // At 30.5 of 60, half of the hot scale is red with half of yellow.
  const Rgba middle = FusedPixel(pixels, 30, 30);
  EXPECT_EQ(middle[0], 255);
  EXPECT_NEAR(middle[1], 255.0 * (3.0 * 30.5 / 60.0 - 1.0), 3.0);
  EXPECT_EQ(middle[2], 0);
  EXPECT_EQ(middle[3], 128);
  EXPECT_EQ(FusedPixel(pixels, 61, 30)[3], 0);
  EXPECT_EQ(FusedPixel(pixels, 30, 61)[3], 0);
}

// Hot colours are light over the scan below: without tracer nothing of the scan is darkened.
TEST(SliceFusing, TheBlackOfABlendedColourMapIsTransparent)
{
  const FusedSlice fused = { SliceColors::Hot, 0.5, SliceFusion::Blend };
  const auto pixels = FusedPixels(FusedRamp(), FusedRequest(), fused);
  // At 0.5 of 60 a fortieth of full red, at 10.5 half of it and a bit.
  EXPECT_NEAR(FusedPixel(pixels, 0, 30)[3], 0.5 * 255.0 * 3.0 * 0.5 / 60.0, 2.0);
  const Rgba dim = FusedPixel(pixels, 10, 30);
  EXPECT_EQ(dim[0], 255);
  EXPECT_EQ(dim[1], 0);
  EXPECT_NEAR(dim[3], 0.5 * 255.0 * 3.0 * 10.5 / 60.0, 2.0);
  // Black in greys is a value, and so it is in a checkerboard.
  EXPECT_EQ(FusedPixel(FusedPixels(FusedRamp(), FusedRequest(),
                         { SliceColors::Gray, 0.5, SliceFusion::Blend }),
              0, 30)[3],
    128);
  EXPECT_EQ(FusedPixel(FusedPixels(FusedRamp(), FusedRequest(),
                         { SliceColors::Hot, 1.0, SliceFusion::Checkerboard }),
              0, 30)[3],
    255);
}

TEST(SliceFusing, TheSquaresOfACheckerboardAlternateAndStayInThePatient)
{
  const FusedSlice fused = { SliceColors::Gray, 1.0, SliceFusion::Checkerboard };
  const auto pixels = FusedPixels(FusedRamp(), FusedRequest(), fused);
  EXPECT_EQ(FusedPixel(pixels, 10, 10)[3], 0);
  EXPECT_EQ(FusedPixel(pixels, 30, 10)[3], 255);
  EXPECT_EQ(FusedPixel(pixels, 10, 30)[3], 255);
  EXPECT_EQ(FusedPixel(pixels, 30, 30)[3], 0);
  EXPECT_EQ(FusedPixel(pixels, 19, 10)[3], 0);
  EXPECT_EQ(FusedPixel(pixels, 20, 10)[3], 255);
  SliceRequest moved = FusedRequest();
  moved.middleMm[0] += 7.0;
  const auto movedPixels = FusedPixels(FusedRamp(), moved, fused);
  EXPECT_EQ(FusedPixel(movedPixels, 12, 10)[3], 0);
  EXPECT_EQ(FusedPixel(movedPixels, 13, 10)[3], 255);
}
