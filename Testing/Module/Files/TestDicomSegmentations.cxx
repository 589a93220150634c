// DICOM segmentations: the masks of segments become labels of voxels.
#include "DicomReading.h"
#include "PhantomSegmentation.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkMath.h>

#include <cmath>
#include <set>

namespace
{

using phantom_dicom::DescribedSegment;
using phantom_dicom::Elements;
using phantom_dicom::SegmentationType;
using phantom_dicom::SegmentFrame;

constexpr int PixelCount = 5 * 4;

/// A mask of a slice with these pixels set to a value.
SegmentFrame Frame(int segment, int slice, const std::set<int>& pixels, int value = 1)
{
  SegmentFrame frame = { segment, slice, std::vector<int>(PixelCount, 0) };
  for (const int pixel : pixels)
  {
    frame.pixels[std::size_t(pixel)] = value;
  }
  return frame;
}

class DicomSegmentations : public DicomReading
{
protected:
  void WriteSegments(const std::vector<DescribedSegment>& segments,
    const std::vector<SegmentFrame>& frames, SegmentationType type = SegmentationType::Binary)
  {
    this->Write("segments", phantom_dicom::Segmentation(this->grid, segments, frames, type));
  }

  /// Removes the distance of slices, so that only their thickness is left.
  void WithoutDistance(Elements& elements) const
  {
    elements[0x52009229] = phantom_dicom::SharedItems(this->grid, false);
  }

  /// The pixels of a slice of the grid whose voxels have a label.
  std::set<int> PixelsOf(int label, int slice)
  {
    vtkImageData* const image = this->reader->GetOutput();
    std::set<int> pixels;
    for (int pixel = 0; pixel < PixelCount; ++pixel)
    {
      if (image->GetScalarComponentAsDouble(pixel % 5, pixel / 5, slice, 0) == label)
      {
        pixels.insert(pixel);
      }
    }
    return pixels;
  }

  StoredVolume grid = []
  {
    StoredVolume volume = phantom::Stored(0);
    volume.dimensions[2] = 6;
    return volume;
  }();
};

}

TEST_F(DicomSegmentations, HaveTheirFramesWhereTheseSay)
{
  // Frames of 20 bits begin within a byte. Slice 2 has none, and their order is not that of places.
  WriteSegments({ { 1, "liver" }, { 2, "spleen" } },
    { Frame(1, 3, { 0, 1, 7, 19 }), Frame(1, 1, { 4, 5 }), Frame(2, 4, { 2, 3, 18 }),
      Frame(2, 1, { 6 }) });
  vtkImageData* const image = this->Read();
  ASSERT_EQ(image->GetDimensions()[2], 4) << this->reader->GetErrorMessage();
  EXPECT_EQ(this->PixelsOf(1, 0), (std::set<int>{ 4, 5 }));
  EXPECT_EQ(this->PixelsOf(2, 0), (std::set<int>{ 6 }));
  EXPECT_EQ(this->PixelsOf(0, 1).size(), PixelCount);
  EXPECT_EQ(this->PixelsOf(1, 2), (std::set<int>{ 0, 1, 7, 19 }));
  EXPECT_EQ(this->PixelsOf(2, 3), (std::set<int>{ 2, 3, 18 }));
  EXPECT_EQ(this->Warnings(), "");
  // The first slice of the image is slice 1 of the grid.
  double placeMm[3];
  image->TransformIndexToPhysicalPoint(1, 2, 2, placeMm);
  const glm::dvec3 index = phantom::IndexAt({ placeMm[0], placeMm[1], placeMm[2] });
  EXPECT_NEAR(glm::distance(index, glm::dvec3(1, 2, 3)), 0.0, 1e-5);
}

TEST_F(DicomSegmentations, NameTheirSegments)
{
  // CIELab 53.24, 80.09, 67.20 is red (D65).
  const auto word = [](double part) { return int(std::lround(65535.0 * part)); };
  WriteSegments({ { 1, "liver", { word(0.5324), word(208.09 / 255.0), word(195.2 / 255.0) } },
                  { 9, "kidney, left" } },
    { Frame(1, 0, { 0 }), Frame(9, 1, { 3 }) });
  this->Read();
  EXPECT_TRUE(this->reader->HoldsLabels());
  const auto segments = this->reader->GetSegments();
  ASSERT_EQ(segments.size(), 2);
  EXPECT_EQ(segments[0].Value, 1);
  EXPECT_EQ(segments[0].Name, "liver");
  ASSERT_TRUE(segments[0].HasColor);
  EXPECT_NEAR(segments[0].Color[0], 1.0, 0.01);
  EXPECT_NEAR(segments[0].Color[1], 0.0, 0.01);
  EXPECT_NEAR(segments[0].Color[2], 0.0, 0.01);
  EXPECT_EQ(segments[1].Value, 9);
  EXPECT_EQ(segments[1].Name, "kidney, left");
  EXPECT_FALSE(segments[1].HasColor);
  EXPECT_EQ(this->PixelsOf(9, 1), (std::set<int>{ 3 }));
  EXPECT_STREQ(this->reader->GetModality(), "SEG");
  EXPECT_STREQ(this->reader->GetFrameOfReferenceUID(), "1.2.52");
}

TEST_F(DicomSegmentations, TheLaterOfTwoThatOverlapWins)
{
  WriteSegments({ { 1, "liver" }, { 2, "tumour" } },
    { Frame(2, 0, { 1, 2 }), Frame(1, 0, { 0, 1, 2, 3 }), Frame(1, 1, { 0 }) });
  this->Read();
  EXPECT_EQ(this->PixelsOf(2, 0), (std::set<int>{ 1, 2 }));
  EXPECT_EQ(this->PixelsOf(1, 0), (std::set<int>{ 0, 3 }));
  this->ExpectWarning("\"tumour\" over \"liver\" (2 voxels)");
}

TEST_F(DicomSegmentations, OfFractionsTakeHalfAVoxelAndMore)
{
  SegmentFrame frame = Frame(1, 0, { 2 }, 99);
  frame.pixels[3] = 100;
  frame.pixels[4] = 200;
  WriteSegments(
    { { 1, "liver" } }, { frame, Frame(1, 1, { 0 }, 200) }, SegmentationType::Fractional);
  this->Read();
  EXPECT_EQ(this->PixelsOf(1, 0), (std::set<int>{ 3, 4 }));
  this->ExpectWarning("fractional");
}

TEST_F(DicomSegmentations, OfLabelsAreReadAsThese)
{
  SegmentFrame frame = Frame(0, 0, { 2 }, 7);
  frame.pixels[3] = 200;
  WriteSegments({ { 7, "liver" } }, { frame, Frame(0, 1, { 0 }, 7) }, SegmentationType::Labels);
  this->Read();
  EXPECT_EQ(this->PixelsOf(7, 0), (std::set<int>{ 2 }));
  EXPECT_EQ(this->PixelsOf(200, 0), (std::set<int>{ 3 }));
  EXPECT_EQ(this->PixelsOf(7, 1), (std::set<int>{ 0 }));
}

TEST_F(DicomSegmentations, OfOneFrameHaveTheStatedThickness)
{
  WriteSegments({ { 1, "liver" } }, { Frame(1, 2, { 8 }) });
  vtkImageData* const image = this->Read();
  ASSERT_EQ(image->GetDimensions()[2], 1);
  EXPECT_NEAR(image->GetSpacing()[2], glm::length(this->grid.axesMm[2]), 1e-6);
  EXPECT_EQ(this->PixelsOf(1, 0), (std::set<int>{ 8 }));
}

// Slices 0, 1, 2, 4, 6 of a scan whose upper part is scanned half as finely, without the distance.
TEST_F(DicomSegmentations, OfTwoDistancesReachHalfWayToTheNextFrame)
{
  Elements elements = phantom_dicom::Segmentation(this->grid, { { 1, "liver" } },
    { Frame(1, 0, { 0 }), Frame(1, 1, { 0 }), Frame(1, 2, { 0 }), Frame(1, 4, { 0 }),
      Frame(1, 6, { 1 }) });
  this->WithoutDistance(elements);
  this->Write("segments", elements);
  ASSERT_EQ(this->Read()->GetDimensions()[2], 7) << this->reader->GetErrorMessage();
  for (int slice = 0; slice < 6; ++slice)
  {
    EXPECT_EQ(this->PixelsOf(1, slice), (std::set<int>{ 0 })) << slice;
  }
  EXPECT_EQ(this->PixelsOf(1, 6), (std::set<int>{ 1 }));
  this->ExpectWarning("lie at two distances");
}

TEST_F(DicomSegmentations, OfSparseFramesAreAsThickAsTheySay)
{
  Elements elements = phantom_dicom::Segmentation(
    this->grid, { { 1, "liver" } }, { Frame(1, 0, { 0 }), Frame(1, 4, { 0 }), Frame(1, 8, { 0 }) });
  this->WithoutDistance(elements);
  this->Write("segments", elements);
  ASSERT_EQ(this->Read()->GetDimensions()[2], 9) << this->reader->GetErrorMessage();
  EXPECT_EQ(this->PixelsOf(1, 4), (std::set<int>{ 0 }));
  EXPECT_EQ(this->PixelsOf(1, 3), (std::set<int>{}));
  this->ExpectWarning("each was taken to be as thick as stated");
}

TEST_F(DicomSegmentations, ComeAfterTheScanInAFolder)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write("slice" + std::to_string(slice), Slice(slice));
  }
  WriteSegments({ { 1, "liver" } },
    { Frame(1, 0, { 0 }), Frame(1, 1, { 0 }), Frame(1, 2, { 0 }), Frame(1, 3, { 0 }) });
  this->Read();
  this->ExpectPhantom();
  EXPECT_FALSE(this->reader->HoldsLabels());
  const auto series = this->reader->ListDICOMSeries();
  ASSERT_EQ(series.size(), 2);
  EXPECT_EQ(series[1].Modality, "SEG");
  EXPECT_EQ(series[1].NumberOfImages, 4);
}

TEST_F(DicomSegmentations, WithoutPositionsAreRefused)
{
  Elements elements =
    phantom_dicom::Segmentation(this->grid, { { 1, "liver" } }, { Frame(1, 0, { 0 }) });
  elements.erase(0x52009230);
  this->Write("segments", elements);
  const ExpectedVtkErrors errors;
  this->Read();
  const std::string message = this->reader->GetErrorMessage();
  EXPECT_NE(
    message.find("the position, orientation and pixel spacing of each frame"), std::string::npos)
    << message;
}

TEST_F(DicomSegmentations, ThatEndEarlyKeepTheFramesBefore)
{
  Elements elements = phantom_dicom::Segmentation(
    this->grid, { { 1, "liver" } }, { Frame(1, 0, { 0 }), Frame(1, 1, { 0 }), Frame(1, 2, { 5 }) });
  std::string& bytes = elements[0x7fe00010].value;
  bytes.resize(6); // 48 of 60 bits
  this->Write("segments", elements);
  ASSERT_EQ(this->Read()->GetDimensions()[2], 2) << this->reader->GetErrorMessage();
  EXPECT_EQ(this->PixelsOf(1, 1), (std::set<int>{ 0 }));
  this->ExpectWarning("bytes of pixels");
}
