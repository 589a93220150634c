// The values of DICOM pixels: their coding, sign and bits, and what they stand for.
#include "DicomReading.h"
#include "DicomTags.h"
#include "Readers/ImageFacts.h"
#include "Support/ExpectedVtkErrors.h"

#include <numeric>

namespace
{

using phantom_dicom::Decimals;
using phantom_dicom::Elements;
using phantom_dicom::Pixels;
using phantom_dicom::Shorts;
using phantom_dicom::Text;
using namespace dicom_tags;

/// The values 0, 1, ... of the 20 pixels of a slice.
std::vector<int> Counted(int first = 0)
{
  std::vector<int> values(20);
  std::iota(values.begin(), values.end(), first);
  return values;
}

class DicomValues : public DicomReading
{
protected:
  /// Value of a pixel of a file's only frame.
  double ValueOf(const Elements& elements, int pixel, int component = 0,
    const std::string& syntax = phantom_dicom::ExplicitSyntax)
  {
    this->Write("file.dcm", elements, syntax);
    vtkImageData* const image = this->Read("file.dcm");
    EXPECT_STREQ(this->reader->GetErrorMessage(), "");
    return image->GetNumberOfPoints() == 20
      ? image->GetScalarComponentAsDouble(pixel % 5, pixel / 5, 0, component)
      : NAN;
  }
};

TEST_F(DicomValues, SignBitsAndScaleBelongToEachSlice)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    if (slice == 1)
    {
      // Stored as 12 unsigned bits with an offset, and with other bits above.
      std::vector<int> values;
      for (int pixel = 0; pixel < 20; ++pixel)
      {
        const double value = phantom::ValueAt({ pixel % 5, pixel / 5, slice });
        values.push_back((int(value) + 1000) | 0xa000);
      }
      elements[BitsStored] = Shorts({ 12 });
      elements[HighBit] = Shorts({ 11 });
      elements[PixelRepresentation] = Shorts({ 0 });
      elements[Intercept] = Decimals({ -1000.0 });
      elements[PixelData] = Pixels(values);
    }
    this->Write(std::to_string(slice), elements);
  }
  EXPECT_EQ(this->Read()->GetScalarType(), VTK_SHORT);
  this->ExpectPhantom();
}

TEST_F(DicomValues, AMissingSlopeIs1AndAMissingInterceptIs0)
{
  Elements elements = Slice(0);
  elements[PixelData] = Pixels(Counted());
  elements[Slope] = Decimals({ 2.5 });
  elements.erase(Intercept);
  EXPECT_EQ(this->ValueOf(elements, 7), 17.5);
  elements[Intercept] = Decimals({ -1024 });
  elements.erase(Slope);
  EXPECT_EQ(this->ValueOf(elements, 7), -1017.0);
  elements[Intercept] = Text("DS", "");
  EXPECT_EQ(this->ValueOf(elements, 7), 7.0);
}

TEST_F(DicomValues, AModalityTableReplacesStoredValues)
{
  Elements elements = Slice(0);
  elements[PixelData] = Pixels(Counted());
  elements.erase(Slope);
  elements.erase(Intercept);
  elements[ModalityTable] = phantom_dicom::Sequence(
    { { { 0x00283002, Shorts({ 4, 5, 16 }) }, { 0x00283006, Shorts({ 100, 200, 40000, 300 }) } } });
  EXPECT_EQ(this->ValueOf(elements, 2), 100.0) << "below the first entry";
  EXPECT_EQ(this->ValueOf(elements, 5), 100.0);
  EXPECT_EQ(this->ValueOf(elements, 7), 40000.0);
  EXPECT_EQ(this->ValueOf(elements, 19), 300.0) << "above the last entry";
}

TEST_F(DicomValues, AModalityTableOf8BitsHasTwoEntriesInAWord)
{
  Elements elements = Slice(0);
  elements[PixelData] = Pixels(Counted());
  elements.erase(Slope);
  elements.erase(Intercept);
  elements[ModalityTable] = phantom_dicom::Sequence({ { { 0x00283002, Shorts({ 4, 0, 8 }) },
    { 0x00283006, { "OW", std::string("\xff\xfe\xfd\xfc", 4) } } } });
  EXPECT_EQ(this->ValueOf(elements, 0), 255.0);
  EXPECT_EQ(this->ValueOf(elements, 3), 252.0);
}

TEST_F(DicomValues, ARealWorldMapIsAppliedOrNamed)
{
  const double slope = 0.5;
  const double intercept = -3.0;
  const auto bytes = [](double number)
  {
    return phantom_dicom::Element{ "FD",
      std::string(reinterpret_cast<const char*>(&number), sizeof(number)) };
  };
  Elements elements = Slice(0);
  elements[PixelData] = Pixels(Counted());
  elements[0x00409096] = phantom_dicom::Sequence({ { { 0x00409210, Text("SH", "ADC") },
    { 0x00409224, bytes(intercept) }, { 0x00409225, bytes(slope) } } });
  EXPECT_EQ(this->ValueOf(elements, 7), 7.0);
  this->ExpectWarning("The files also map their values to \"ADC\"; this map was not applied.");
  elements.erase(Slope);
  elements.erase(Intercept);
  EXPECT_EQ(this->ValueOf(elements, 7), 0.5);
  EXPECT_EQ(this->Warnings(), "");
  EXPECT_EQ(this->reader->GetWindow(), 200.0);
  EXPECT_EQ(this->reader->GetLevel(), 17.0);
}

TEST_F(DicomValues, StoredBitsMayBeTheHighOnes)
{
  Elements elements = Slice(0);
  std::vector<int> values = Counted(-5);
  for (int& value : values)
  {
    value *= 16;
  }
  elements[PixelData] = Pixels(values);
  elements[BitsStored] = Shorts({ 12 });
  EXPECT_EQ(this->ValueOf(elements, 2), -3.0);
  elements[PixelRepresentation] = Shorts({ 0 });
  EXPECT_EQ(this->ValueOf(elements, 2), 4093.0);
}

TEST_F(DicomValues, BrightPaddingBecomesTheLowestValue)
{
  Elements elements = Slice(0);
  std::vector<int> values = Counted(1000);
  values[3] = 63536;
  elements[PixelData] = Pixels(values);
  elements[PixelRepresentation] = Shorts({ 0 });
  elements[Intercept] = Decimals({ -1024 });
  elements[Padding] = Shorts({ 63536 });
  EXPECT_EQ(this->ValueOf(elements, 3), -24.0);
  EXPECT_EQ(this->ValueOf(elements, 19), -5.0);
  this->ExpectWarning("with values up to 62512, were set to its lowest value, -24.");
}

TEST_F(DicomValues, DarkPaddingStays)
{
  Elements elements = Slice(0);
  std::vector<int> values = Counted();
  values[3] = -2000;
  elements[PixelData] = Pixels(values);
  elements[Padding] = { "SS", Shorts({ -2000 }).value };
  EXPECT_EQ(this->ValueOf(elements, 3), -2000.0);
  EXPECT_EQ(this->Warnings(), "");
  EXPECT_EQ(varimarch::LowestInside(this->reader->GetOutput()), 0.0)
    << "it is told apart from the image";
}

TEST_F(DicomValues, TheirSmallestMayBeMeantWhite)
{
  Elements elements = Slice(0);
  const double value = this->ValueOf(elements, 7);
  EXPECT_FALSE(this->reader->IsInverted());
  elements[Colours] = Text("CS", "MONOCHROME1");
  EXPECT_EQ(this->ValueOf(elements, 7), value) << "values stay as they are";
  EXPECT_TRUE(this->reader->IsInverted());
  elements[Colours] = Text("CS", "MONOCHROME2");
  elements[PresentationShape] = Text("CS", "INVERSE");
  this->ValueOf(elements, 0);
  EXPECT_TRUE(this->reader->IsInverted());
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomValues, NumbersOfColoursBecomeColours)
{
  Elements elements = Slice(0);
  std::string bytes;
  for (const int value : Counted())
  {
    bytes += char(value);
  }
  elements[Colours] = Text("CS", "PALETTE COLOR");
  elements[BitsAllocated] = Shorts({ 8 });
  elements[BitsStored] = Shorts({ 8 });
  elements[HighBit] = Shorts({ 7 });
  elements[PixelRepresentation] = Shorts({ 0 });
  elements[PixelData] = { "OW", bytes };
  for (int colour = 0; colour < 3; ++colour)
  {
    std::vector<int> table;
    for (int i = 0; i < 20; ++i)
    {
      table.push_back((10 * colour + i) * 257);
    }
    elements[0x00281101 + std::uint32_t(colour)] = Shorts({ 20, 0, 16 });
    elements[0x00281201 + std::uint32_t(colour)] = Pixels(table);
  }
  for (int colour = 0; colour < 3; ++colour)
  {
    EXPECT_EQ(this->ValueOf(elements, 7, colour), 10.0 * colour + 7.0);
  }
}

TEST_F(DicomValues, RescaledColoursDoNotOverflow)
{
  Elements elements = Slice(0);
  std::string bytes;
  for (const int value : Counted())
  {
    bytes += std::string(2, char(0)) + char(200 + value);
  }
  elements[Samples] = Shorts({ 3 });
  elements[0x00280006] = Shorts({ 0 }); // colour by pixel
  elements[Colours] = Text("CS", "RGB");
  elements[BitsAllocated] = Shorts({ 8 });
  elements[BitsStored] = Shorts({ 8 });
  elements[HighBit] = Shorts({ 7 });
  elements[PixelRepresentation] = Shorts({ 0 });
  elements[Slope] = Decimals({ 1000 });
  elements[PixelData] = { "OW", bytes };
  EXPECT_EQ(this->ValueOf(elements, 7, 2), 207000.0);
  EXPECT_EQ(this->ValueOf(elements, 7, 0), 0.0);
}

TEST_F(DicomValues, RunLengthsMayBeInSeveralFragments)
{
  Elements elements = Slice(0);
  for (const int fragments : { 1, 3 })
  {
    elements[PixelData] = phantom_dicom::RunLengthPixels(Counted(250), fragments);
    EXPECT_EQ(this->ValueOf(elements, 19, 0, phantom_dicom::RunLengthSyntax), 269.0)
      << fragments << " fragments";
    EXPECT_EQ(this->ValueOf(elements, 0, 0, phantom_dicom::RunLengthSyntax), 250.0);
  }
}

TEST_F(DicomValues, FilesMayBeDeflated)
{
  Elements elements = Slice(0);
  elements[PixelData] = Pixels(Counted());
  EXPECT_EQ(this->ValueOf(elements, 19, 0, phantom_dicom::DeflatedSyntax), 19.0);
}

TEST_F(DicomValues, AnUnknownCodingIsNamed)
{
  Elements elements = Slice(0);
  elements[PixelData] = phantom_dicom::RunLengthPixels(Counted(), 1);
  const std::pair<const char*, const char*> codings[] = { { "1.2.840.10008.1.2.4.999",
                                                            "\"1.2.840.10008.1.2.4.999\"" },
    { "1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000 (1.2.840.10008.1.2.4.203)" } };
  const ExpectedVtkErrors errors;
  for (const auto& [uid, name] : codings)
  {
    this->Write("file.dcm", elements, uid);
    this->Read("file.dcm");
    const std::string message = this->reader->GetErrorMessage();
    const std::string expected = "expected a known coding of the pixels, found ";
    EXPECT_NE(message.find(expected + name + "."), std::string::npos) << message;
  }
  EXPECT_EQ(errors.Messages().size(), 2u);
}

TEST_F(DicomValues, ADamagedSliceIsNamedAndTheOthersAreRead)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write(std::to_string(slice), Slice(slice));
  }
  Elements unknown = Slice(2, 50);
  unknown[0x00200032] = Decimals({ 500, 0, 0 });
  unknown[PixelData] = phantom_dicom::RunLengthPixels(Counted(), 1);
  // A place of its own between two others.
  Elements between = Slice(1, 60);
  const StoredVolume volume = phantom::Stored(0);
  const glm::dvec3 placeMm = volume.originMm + 0.5 * volume.axesMm[2];
  between[0x00200032] = Decimals({ placeMm.x, placeMm.y, placeMm.z });
  between[PixelData] = unknown[PixelData];
  this->Write("between", between, "1.2.840.10008.1.2.4.999");
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("scan/between\" were left out: expected a known coding");
}

}
