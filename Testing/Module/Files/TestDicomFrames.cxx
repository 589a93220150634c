// DICOM files with several frames: stacks, times, doses, mosaics.
#include "DicomReading.h"
#include "DicomTags.h"
#include "Support/ExpectedVtkErrors.h"

#include <glm/geometric.hpp>

namespace
{

using phantom_dicom::Decimals;
using phantom_dicom::Element;
using phantom_dicom::Elements;
using phantom_dicom::Pixels;
using phantom_dicom::Sequence;
using phantom_dicom::Shorts;
using phantom_dicom::Text;
using namespace dicom_tags;

class DicomFrames : public DicomReading
{
protected:
  /// A file with frames whose pixels have the values 100, 101, ... by frame, without positions.
  static Elements File(int frameCount)
  {
    Elements elements = Slice(0);
    elements[Frames] = Text("IS", std::to_string(frameCount));
    elements[Position] = Decimals({ -10, -20, 30 });
    elements[Orientation] = Decimals({ 1, 0, 0, 0, 1, 0 });
    std::vector<int> values;
    for (int frame = 0; frame < frameCount; ++frame)
    {
      values.insert(values.end(), 20, 100 + frame);
    }
    elements[PixelData] = Pixels(values);
    return elements;
  }

  /// A file with frames at these heights [mm], each with more attributes of its own.
  static Elements EnhancedFile(
    const std::vector<double>& heightsMm, const std::vector<Elements>& attributes = {})
  {
    Elements elements = File(int(heightsMm.size()));
    elements.erase(Position);
    std::vector<Elements> frames;
    for (std::size_t i = 0; i < heightsMm.size(); ++i)
    {
      Elements frame = i < attributes.size() ? attributes[i] : Elements();
      frame[0x00209113] = Sequence({ { { Position, Decimals({ 0, 0, heightsMm[i] }) } } });
      frames.push_back(frame);
    }
    elements[SharedGroups] =
      Sequence({ { { 0x00289110, Sequence({ { { PixelSpacing, Decimals({ 1, 1 }) } } }) } } });
    elements[FrameGroups] = Sequence(frames);
    return elements;
  }

  /// Expects slices with these values, at this distance.
  void ExpectSlices(const Elements& elements, const std::vector<double>& values, double distanceMm)
  {
    this->Write("file.dcm", elements);
    vtkImageData* const image = this->Read("file.dcm");
    ASSERT_EQ(image->GetNumberOfPoints(), 20 * vtkIdType(values.size()))
      << this->reader->GetErrorMessage() << this->Warnings();
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      // A float has a precision of 6e-8.
      EXPECT_NEAR(image->GetScalarComponentAsDouble(2, 1, int(i), 0), values[i], 6e-8 * values[i])
        << i;
    }
    EXPECT_NEAR(image->GetSpacing()[2], distanceMm, 1e-9);
  }
};

TEST_F(DicomFrames, OfATomographWithOnePositionAreAStack)
{
  Elements elements = File(4);
  elements[SlicesMm] = Decimals({ 2.5 });
  this->ExpectSlices(elements, { 100, 101, 102, 103 }, 2.5);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[2], 30.0, 1e-9);
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomFrames, OfAFilmAreTimes)
{
  Elements elements = File(4);
  elements[Modality] = Text("CS", "US");
  elements[FrameTime] = Decimals({ 40 });
  this->ExpectSlices(elements, { 100 }, 1.0);
  ASSERT_EQ(this->reader->GetNumberOfTimes(), 4);
  EXPECT_DOUBLE_EQ(this->reader->GetTimeValue(3), 0.12);
}

// A distance of slices does not make slices of images that differ in their times.
TEST_F(DicomFrames, OfOnePlaceAreTimesWhateverTheirThickness)
{
  Elements elements = File(4);
  elements[Modality] = Text("CS", "MR");
  elements[SlicesMm] = Decimals({ 8.0 });
  std::vector<Elements> frames;
  for (int i = 0; i < 4; ++i)
  {
    frames.push_back({ { 0x00209111,
      Sequence({ { { 0x00209057, { "UL", Shorts({ 1, 0 }).value } },
        { 0x00209128, { "UL", Shorts({ i + 1, 0 }).value } } } }) } });
  }
  elements[FrameGroups] = Sequence(frames);
  this->ExpectSlices(elements, { 100 }, 8.0);
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 4);
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomFrames, ThatCountTheirSlicesAreStackedInThisOrder)
{
  Elements elements = File(3);
  elements[Modality] = Text("CS", "MR");
  elements[SlicesMm] = Decimals({ 3.0 });
  std::vector<Elements> frames;
  for (const int slice : { 1, 3, 2 })
  {
    frames.push_back(
      { { 0x00209111, Sequence({ { { 0x00209057, { "UL", Shorts({ slice, 0 }).value } } } }) } });
  }
  elements[FrameGroups] = Sequence(frames);
  this->ExpectSlices(elements, { 100, 102, 101 }, 3.0);
}

TEST_F(DicomFrames, OfSeveralDetectorsOrAnglesAreViews)
{
  for (const std::uint32_t vector : { 0x00540020u, 0x00540090u })
  {
    Elements elements = File(2);
    elements[Modality] = Text("CS", "NM");
    elements[SliceThickness] = Decimals({ 2.4 });
    elements[vector] = Shorts({ 1, 2 });
    this->reader->SetDICOMKind(0);
    this->ExpectSlices(elements, { 100 }, 2.4);
    this->ExpectWarning("1 (view 1: frame 1 of \"file.dcm\"), 2 (view 2: frame 2 of ");
    this->reader->SetDICOMKind(2);
    this->ExpectSlices(elements, { 101 }, 2.4);
  }
}

TEST_F(DicomFrames, LieAtTheirSliceLocations)
{
  Elements elements = File(3);
  elements[Modality] = Text("CS", "OT");
  elements[SliceThickness] = Decimals({ 1.0 });
  elements[0x00182005] = Decimals({ 0, 2.5, 5 });
  this->ExpectSlices(elements, { 100, 101, 102 }, 2.5);
}

TEST_F(DicomFrames, OfASlideAreRefused)
{
  Elements elements = File(4);
  elements[Modality] = Text("CS", "SM");
  elements[SliceThickness] = Decimals({ 0.001 });
  elements[0x00480006] = { "UL", Shorts({ 10, 0 }).value };
  elements[0x00480007] = { "UL", Shorts({ 8, 0 }).value };
  this->Write("file.dcm", elements);
  const ExpectedVtkErrors errors;
  this->Read("file.dcm");
  EXPECT_NE(std::string(this->reader->GetErrorMessage())
              .find("expected slices of a volume, found tiles of a flat slide of 10 x 8 pixels."),
    std::string::npos)
    << this->reader->GetErrorMessage();
}

TEST_F(DicomFrames, OfADoseLieAtTheirOffsets)
{
  Elements elements = File(3);
  elements[Modality] = Text("CS", "RTDOSE");
  elements.erase(Slope);
  elements.erase(Intercept);
  elements[0x3004000c] = Decimals({ 0, 5, 10 });
  elements[0x3004000e] = Decimals({ 0.001 });
  this->ExpectSlices(elements, { 0.1, 0.101, 0.102 }, 5.0);
  // Offsets that do not begin with 0 are positions.
  elements[0x3004000c] = Decimals({ 30, 26, 22 });
  this->ExpectSlices(elements, { 0.102, 0.101, 0.1 }, 4.0);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[2], 22.0, 1e-9);
}

TEST_F(DicomFrames, OfNuclearMedicineLieWhereTheDetectorSays)
{
  Elements elements = File(3);
  elements[Modality] = Text("CS", "NM");
  elements[0x00540080] = Shorts({ 1, 2, 3 });
  elements[0x00540022] = Sequence(
    { { { Position, elements.at(Position) }, { Orientation, elements.at(Orientation) } } });
  elements.erase(Position);
  elements.erase(Orientation);
  elements[SlicesMm] = Decimals({ -2.5 });
  this->ExpectSlices(elements, { 102, 101, 100 }, 2.5);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[0], -10.0, 1e-9);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[2], 25.0, 1e-9);
}

TEST_F(DicomFrames, InInterleavedStacksAreOneVolume)
{
  const auto stack = [](const char* name) {
    return Elements{ { 0x00209111, Sequence({ { { 0x00209056, Text("SH", name) } } }) } };
  };
  this->ExpectSlices(EnhancedFile({ 0, 4, 8, 2, 6, 10 },
                       { stack("1"), stack("1"), stack("1"), stack("2"), stack("2"), stack("2") }),
    { 100, 103, 101, 104, 102, 105 }, 2.0);
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomFrames, OfSeveralDirectionsAreNotStacked)
{
  const auto turned = [](const std::vector<double>& axes) {
    return Elements{ { 0x00209116, Sequence({ { { Orientation, Decimals(axes) } } }) } };
  };
  const Elements axial = turned({ 1, 0, 0, 0, 1, 0 });
  const Elements sagittal = turned({ 0, 1, 0, 0, 0, -1 });
  Elements elements = EnhancedFile({ 0, 3, 6, 9 }, { axial, sagittal, axial, axial });
  elements.erase(Orientation);
  this->ExpectSlices(elements, { 100, 102, 103 }, 3.0);
  this->ExpectWarning("2 (sagittal: frame 2 of \"file.dcm\")");
}

TEST_F(DicomFrames, OfSeveralTimesAreRead)
{
  const auto time = [](int index)
  {
    return Elements{ { 0x00209111,
      Sequence({ { { 0x00209128, { "UL", Shorts({ index, 0 }).value } } } }) } };
  };
  this->ExpectSlices(
    EnhancedFile({ 0, 2, 0, 2 }, { time(2), time(2), time(1), time(1) }), { 102, 103 }, 2.0);
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 2);
}

TEST_F(DicomFrames, OfAnUltrasoundVolumeArePlacedInIt)
{
  Elements elements = EnhancedFile({ 0, 0, 0 });
  elements.erase(Orientation);
  elements[Modality] = Text("CS", "US");
  std::vector<Elements> frames;
  for (int i = 0; i < 3; ++i)
  {
    frames.push_back(
      { { 0x0020930e, Sequence({ { { 0x00209301, Decimals({ 0, 0, 0.5 * i }) } } }) } });
  }
  elements[FrameGroups] = Sequence(frames);
  elements[SharedGroups] = Sequence(
    { { { 0x0020930f, Sequence({ { { 0x00209302, Decimals({ 1, 0, 0, 0, 1, 0 }) } } }) } } });
  this->ExpectSlices(elements, { 100, 101, 102 }, 0.5);
  this->ExpectWarning("which side is the patient's left");
}

TEST_F(DicomFrames, BeforeTheEndOfATruncatedFileAreRead)
{
  Elements elements = File(4);
  elements[SlicesMm] = Decimals({ 2.5 });
  const std::string whole = phantom_dicom::FileBytes(elements);
  this->folder.Write("scan/cut.dcm", whole.substr(0, whole.size() - 50));
  vtkImageData* const image = this->Read("cut.dcm");
  ASSERT_EQ(image->GetDimensions()[2], 2) << this->reader->GetErrorMessage();
  EXPECT_EQ(image->GetScalarComponentAsDouble(4, 3, 1, 0), 101.0);
  this->ExpectWarning("expected 160 bytes of pixels, found 110");
}

TEST_F(DicomFrames, OfUltrasoundHaveThePixelsOfTheirRegion)
{
  Elements elements = Slice(0);
  elements.erase(PixelSpacing);
  elements[0x00186011] = Sequence({ { { 0x00186024, Shorts({ 3 }) }, { 0x00186026, Shorts({ 3 }) },
    { 0x0018602c, { "FD", std::string("\x9a\x99\x99\x99\x99\x99\xa9\x3f", 8) } }, // 0.05 cm
    { 0x0018602e, { "FD", std::string("\x9a\x99\x99\x99\x99\x99\xb9\x3f", 8) } } } });
  this->Write("file.dcm", elements);
  vtkImageData* const image = this->Read("file.dcm");
  EXPECT_NEAR(image->GetSpacing()[0], 0.5, 1e-12);
  EXPECT_NEAR(image->GetSpacing()[1], 1.0, 1e-12);
}

TEST_F(DicomFrames, OfUltrasoundDoNotHaveThePixelsOfATrace)
{
  const std::string half("\x9a\x99\x99\x99\x99\x99\xa9\x3f", 8);  // 0.05
  const std::string tenth("\x9a\x99\x99\x99\x99\x99\xb9\x3f", 8); // 0.1
  const auto region = [&](int format, const std::string& size)
  {
    return Elements{ { 0x00186012, Shorts({ format }) }, { 0x00186024, Shorts({ 3 }) },
      { 0x00186026, Shorts({ 3 }) }, { 0x0018602c, { "FD", size } },
      { 0x0018602e, { "FD", size } } };
  };
  Elements elements = Slice(0);
  elements.erase(PixelSpacing);
  elements[0x00186011] = Sequence({ region(3, tenth), region(1, half) });
  this->Write("file.dcm", elements);
  EXPECT_NEAR(this->Read("file.dcm")->GetSpacing()[0], 0.5, 1e-12);
}

TEST_F(DicomFrames, HaveThePixelsOfTheImagerOr1MmWithAWarning)
{
  Elements elements = Slice(0);
  elements[0x00181164] = Decimals({ 0.8, 0.7 });
  elements.erase(PixelSpacing);
  this->Write("file.dcm", elements);
  EXPECT_NEAR(this->Read("file.dcm")->GetSpacing()[1], 0.8, 1e-12);
  EXPECT_EQ(this->Warnings(), "");
  elements.erase(0x00181164);
  this->Write("file.dcm", elements);
  EXPECT_EQ(this->Read("file.dcm")->GetSpacing()[1], 1.0);
  this->ExpectWarning("does not say how large a pixel is");
}

/// Siemens' private header "CSA" with one value per attribute (nibabel, "Siemens format DICOM with
/// CSA header").
Element SiemensHeader(const std::map<std::string, std::vector<std::string>>& attributes)
{
  const auto number = [](int value) { return Shorts({ value & 0xffff, value >> 16 }).value; };
  std::string bytes = std::string("SV10\4\3\2\1", 8) + number(int(attributes.size())) + number(77);
  for (const auto& [name, values] : attributes)
  {
    std::string padded = name;
    padded.resize(64);
    bytes += padded + number(int(values.size())) + std::string("FD\0\0", 4) + number(4) +
      number(int(values.size())) + number(77);
    for (const std::string& value : values)
    {
      std::string text = value + '\0';
      const int length = int(text.size());
      text.resize((text.size() + 3) / 4 * 4);
      bytes += number(length) + number(length) + number(77) + number(length) + text;
    }
  }
  return { "OB", bytes };
}

TEST_F(DicomFrames, OfAMosaicAreItsTiles)
{
  // Three tiles of 2 x 2 pixels in a picture of 4 x 4; slices follow each other against the normal.
  Elements elements = Slice(0);
  elements[0x00080008] = Text("CS", "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
  elements[0x00080070] = Text("LO", "SIEMENS");
  elements[Modality] = Text("CS", "MR");
  elements[0x00280010] = Shorts({ 4 });
  elements[0x00280011] = Shorts({ 4 });
  elements[PixelSpacing] = Decimals({ 3, 2 });
  elements[SlicesMm] = Decimals({ 5 });
  elements[Position] = Decimals({ -10, -20, 30 });
  elements[Orientation] = Decimals({ 1, 0, 0, 0, 1, 0 });
  elements[0x00290010] = Text("LO", "SIEMENS CSA HEADER");
  elements[0x00291010] = SiemensHeader(
    { { "NumberOfImagesInMosaic", { "3" } }, { "SliceNormalVector", { "0.0", "0.0", "-1.0" } } });
  elements[PixelData] = Pixels({ 11, 12, 21, 22, 13, 14, 23, 24, 31, 32, 0, 0, 33, 34, 0, 0 });
  this->Write("file.dcm", elements);
  vtkImageData* const image = this->Read("file.dcm");
  ASSERT_EQ(image->GetNumberOfPoints(), 12) << this->reader->GetErrorMessage();
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 0, 0), 32.0);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 1, 1, 0), 23.0);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 1, 2, 0), 14.0);
  // The position is that of a picture of 4 x 4 pixels around the centre of a tile.
  EXPECT_NEAR(image->GetOrigin()[0], -10.0 + 2.0, 1e-9);
  EXPECT_NEAR(image->GetOrigin()[1], -20.0 + 3.0, 1e-9);
  EXPECT_NEAR(image->GetOrigin()[2], 30.0 - 10.0, 1e-9);
  EXPECT_NEAR(image->GetSpacing()[2], 5.0, 1e-9);
}

}
