// Segments in slices: outlines and light fill, at the places of the slice's voxels.

#include "Scene/Slices/SliceFusing.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <cstdlib>

using namespace varimarch;

namespace
{

constexpr int SegmentSide = 21;
constexpr int Middle = SegmentSide / 2;

// Voxels of 1 mm, the centre one at the world's origin. Segment 1 is the cube of 11 voxels around
// the origin, and segment 2 the slab of 2 voxels beside it, towards the patient's left.
vtkSmartPointer<vtkImageData> SegmentNumbers()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(SegmentSide, SegmentSide, SegmentSide);
  image->SetOrigin(-Middle, -Middle, -Middle);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int z = -Middle; z <= Middle; ++z)
  {
    for (int y = -Middle; y <= Middle; ++y)
    {
      for (int x = -Middle; x <= Middle; ++x)
      {
        const bool isNear = std::abs(y) <= 5 && std::abs(z) <= 5;
        *static_cast<unsigned char*>(image->GetScalarPointer(x + Middle, y + Middle, z + Middle)) =
          isNear && std::abs(x) <= 5     ? 1
          : isNear && (x == 6 || x == 7) ? 2
                                         : 0;
      }
    }
  }
  return image;
}

std::vector<Segment> Segments()
{
  return { { 10, "cube", { 1.0, 0.0, 0.0 }, true, 0.5 }, { 20, "slab", { 0.0, 0.2, 1.0 } } };
}

// Pixels of 1 mm with the world's origin at the centre pixel.
SliceRequest SegmentRequest(SlicePlane plane)
{
  return { plane, { 0.0, 0.0, 0.0 }, 1.0, SegmentSide, SegmentSide, 255.0, 127.5, 0.0 };
}

Rgba Pixel(const std::vector<Rgba>& picture, int right, int down)
{
  return picture[(down + Middle) * SegmentSide + right + Middle];
}

const Rgba Nothing = { 0, 0, 0, 0 };

TEST(SliceSegments, AreOutlinesAroundALightFill)
{
  const auto picture =
    SliceSegments(SegmentNumbers(), Segments(), SegmentRequest(SlicePlane::Axial));
  EXPECT_EQ(Pixel(picture, 0, 0), (Rgba{ 255, 0, 0, 38 })) << "30 % of half the opacity";
  EXPECT_EQ(Pixel(picture, -5, 0), (Rgba{ 255, 0, 0, 255 })) << "opaque, whatever the opacity";
  EXPECT_EQ(Pixel(picture, -4, 0)[3], 255);
  EXPECT_EQ(Pixel(picture, -3, 0)[3], 38) << "behind an outline of two pixels";
  EXPECT_EQ(Pixel(picture, 5, 0), (Rgba{ 255, 0, 0, 255 })) << "another segment begins";
  EXPECT_EQ(Pixel(picture, 6, 0), (Rgba{ 0, 51, 255, 255 }));
  EXPECT_EQ(Pixel(picture, -6, 0), Nothing);
  EXPECT_EQ(Pixel(picture, 0, 6), Nothing);
}

TEST(SliceSegments, LieWhereTheirVoxelsAre)
{
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal })
  {
    const auto picture = SliceSegments(SegmentNumbers(), Segments(), SegmentRequest(plane));
    EXPECT_EQ(Pixel(picture, 7, 0)[2], 255) << "the patient's left is on the right";
    EXPECT_EQ(Pixel(picture, -7, 0), Nothing);
  }
  SliceRequest sagittal = SegmentRequest(SlicePlane::Sagittal);
  sagittal.middleMm = { 6.4, 0.0, 0.0 };
  EXPECT_EQ(Pixel(SliceSegments(SegmentNumbers(), Segments(), sagittal), 0, 0)[2], 255)
    << "the nearest voxel";
  sagittal.middleMm = { 7.6, 0.0, 0.0 };
  EXPECT_EQ(Pixel(SliceSegments(SegmentNumbers(), Segments(), sagittal), 0, 0), Nothing);
}

TEST(SliceSegments, LeaveOutWhatIsHidden)
{
  std::vector<Segment> segments = Segments();
  segments[0].visible = false;
  const auto picture = SliceSegments(SegmentNumbers(), segments, SegmentRequest(SlicePlane::Axial));
  EXPECT_EQ(Pixel(picture, 0, 0), Nothing);
  EXPECT_EQ(Pixel(picture, 6, 0)[3], 255);
}

TEST(SliceSegments, EndWithTheVolumeButHaveNoOutlineAtTheEdgeOfTheSlice)
{
  SliceRequest request = SegmentRequest(SlicePlane::Axial);
  request.mmPerPixel = 0.25; // the slice shows 5 mm of the cube
  EXPECT_EQ(Pixel(SliceSegments(SegmentNumbers(), Segments(), request), -Middle, 0)[3], 38);
  request.mmPerPixel = 2.0; // the slice is larger than the volume
  EXPECT_EQ(Pixel(SliceSegments(SegmentNumbers(), Segments(), request), -Middle, 0), Nothing);
}

}
