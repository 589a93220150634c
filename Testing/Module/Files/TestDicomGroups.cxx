// The slices of a series that make up one volume, and those that are left out.
#include "DicomReading.h"
#include "DicomTags.h"

namespace
{

using phantom_dicom::Decimals;
using phantom_dicom::Elements;
using phantom_dicom::Text;
using namespace dicom_tags;

class DicomGroups : public DicomReading
{
protected:
  /// Writes a slice of one of several volumes, whose values are 1000 apart.
  void WriteSliceOf(int volume, int slice, std::uint32_t difference)
  {
    Elements elements = Slice(slice, 10 * volume);
    elements[difference] = Text("IS", std::to_string(volume + 1));
    elements[Intercept] = Decimals({ 1000.0 * volume });
    // Names in no order, so that only attributes can tell the volumes apart.
    this->Write(std::to_string((slice * 5 + volume * 7) % 11), elements);
  }

  /// Writes an axial slice.
  void WriteAt(const std::vector<double>& positionMm, int number, const Elements& more = {})
  {
    Elements elements = more;
    elements.insert({ Orientation, Decimals({ 1, 0, 0, 0, 1, 0 }) });
    elements.insert({ Position, Decimals(positionMm) });
    elements.insert({ InstanceNumber, Text("IS", std::to_string(number)) });
    elements.merge(Slice(0, number));
    this->Write("slice" + std::to_string(number), elements);
  }

  /// Writes slices 2.5 mm apart, which two acquisitions took in turns.
  void WriteInTurns(double thicknessMm)
  {
    for (int i = 0; i < 8; ++i)
    {
      this->WriteAt({ 0, 0, 2.5 * i }, i,
        { { AcquisitionNumber, Text("IS", std::to_string(i % 2 + 1)) },
          { SliceThickness, Decimals({ thicknessMm }) } });
    }
  }

  /// Writes slices at these heights [mm].
  void WriteHeights(const std::vector<double>& heightsMm)
  {
    for (std::size_t i = 0; i < heightsMm.size(); ++i)
    {
      Elements elements = Slice(0, int(i));
      elements[Orientation] = Decimals({ 1, 0, 0, 0, 1, 0 });
      elements[Position] = Decimals({ 0, 0, heightsMm[i] });
      this->Write("slice" + std::to_string(i), elements);
    }
  }
};

TEST_F(DicomGroups, AnAbortedTimeIsLeftOut)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->WriteSliceOf(0, slice, TimePoint);
  }
  this->WriteSliceOf(1, 0, TimePoint);
  this->WriteSliceOf(1, 1, TimePoint);
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("The series holds 2 volumes that differ in their time point; only the first "
                      "complete one was read; volume 2 has 2 of 3 slices.");
}

TEST_F(DicomGroups, TheFirstCompleteTimeIsRead)
{
  this->WriteSliceOf(0, 2, TimePoint);
  for (int slice = 0; slice < 3; ++slice)
  {
    this->WriteSliceOf(1, slice, TimePoint);
  }
  this->Read();
  this->ExpectPhantom(1000.0);
  this->ExpectWarning("volume 1 has 1 of 3 slices");
}

TEST_F(DicomGroups, PhasesWithTheSameNumbersAreTimes)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->WriteSliceOf(0, slice, AcquisitionNumber);
    this->WriteSliceOf(1, slice, AcquisitionNumber);
  }
  this->Read();
  this->ExpectPhantom();
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 2);
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomGroups, PartsAcquiredOneAfterTheOtherStayTogether)
{
  for (int part = 0; part < 2; ++part)
  {
    for (int i = 0; i < 6; ++i)
    {
      // The last slice of the first part is scanned again as the first of the second.
      Elements elements = Slice(0, 20 * part + i);
      elements[Orientation] = Decimals({ 1, 0, 0, 0, 1, 0 });
      elements[Position] = Decimals({ 0, 0, 5.0 * part + i });
      elements[AcquisitionNumber] = Text("IS", std::to_string(part + 1));
      this->Write(std::to_string(10 * part + i), elements);
    }
  }
  EXPECT_EQ(this->Read()->GetDimensions()[2], 11) << this->Warnings();
  this->ExpectWarning("lie at the same place");
}

TEST_F(DicomGroups, ASliceScannedTwiceIsReadOnce)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write(std::to_string(slice), Slice(slice));
  }
  Elements again = Slice(1, 50);
  again[InstanceNumber] = Text("IS", "50");
  again[Intercept] = Decimals({ 500.0 });
  this->Write("again", again);
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("others lie at the same place, and only the first of each place was read: "
                      "\"again\".");
  EXPECT_FALSE(this->reader->HasIrregularSlices());
}

TEST_F(DicomGroups, SlicesWithOtherPixelsAreLeftOut)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write(std::to_string(slice), Slice(slice));
  }
  Elements wide = Slice(2, 50);
  wide[PixelSpacing] = Decimals({ 2.2, 1.4 });
  this->Write("wide", wide);
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("2 (pixels of 1.4 x 2.2 mm: \"wide\")");
}

TEST_F(DicomGroups, AScoutFarAwayIsAKindOfItsOwn)
{
  this->WriteHeights({ 30.0, 32.5, 35.0, 37.5, 200.0 });
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4);
  EXPECT_NEAR(this->reader->GetOutput()->GetSpacing()[2], 2.5, 1e-9);
  this->ExpectWarning("2 (slice at 200 mm: \"slice4\")");
}

// Both breasts in one series: what lies between them must not be closed.
TEST_F(DicomGroups, PartsBeyondAWideGapAreKinds)
{
  this->WriteHeights({ -60, -57.5, -55, 40, 42.5, 45, 47.5 });
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[2], 40.0, 1e-9);
  this->ExpectWarning("1 (slices from 40 to 47.5 mm: ");
  this->reader->SetDICOMKind(2);
  EXPECT_EQ(this->Read()->GetDimensions()[2], 3);
  EXPECT_NEAR(this->reader->GetOutput()->GetOrigin()[2], -60.0, 1e-9);
}

TEST_F(DicomGroups, TimesBetweenEachOthersSlicesAreNotMixed)
{
  for (int i = 0; i < 8; ++i)
  {
    this->WriteAt({ 0, 0, 1.25 * i }, i, { { TimePoint, Text("IS", std::to_string(i % 2 + 1)) } });
  }
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4) << this->Warnings();
  EXPECT_NEAR(this->reader->GetOutput()->GetSpacing()[2], 2.5, 1e-9);
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 2);
  this->reader->SetTimeIndex(1);
  EXPECT_NEAR(this->Read()->GetOrigin()[2], 1.25, 1e-9);
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomGroups, SlicesAcquiredInTurnsStayTogether)
{
  this->WriteInTurns(2.5);
  EXPECT_EQ(this->Read()->GetDimensions()[2], 8) << this->Warnings();
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomGroups, AcquisitionsBetweenThickSlicesAreTimes)
{
  this->WriteInTurns(5.0);
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4) << this->Warnings();
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 2);
}

// Images have 5 x 4 pixels of 0.7 x 1.1 mm.
TEST_F(DicomGroups, StationsOfATableAreNoTimes)
{
  for (int i = 0; i < 8; ++i)
  {
    this->WriteAt({ 0, i < 4 ? 0.0 : 4.0, 2.5 * (i % 4) }, i,
      { { AcquisitionNumber, Text("IS", std::to_string(i / 4 + 1)) } });
  }
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4) << this->Warnings();
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 1);
  this->ExpectWarning("2 (station 2, 4 mm beside the first: ");
  this->reader->SetDICOMKind(2);
  EXPECT_NEAR(this->Read()->GetOrigin()[1], 4.0, 1e-9);
}

TEST_F(DicomGroups, AMovedRepeatIsSaidToLieBeside)
{
  for (int i = 0; i < 4; ++i)
  {
    this->WriteAt({ 0, 0, 2.5 * i }, i);
  }
  this->WriteAt({ 0.5, 0, 2.5 }, 5);
  EXPECT_EQ(this->Read()->GetDimensions()[2], 4) << this->Warnings();
  this->ExpectWarning("others lie at the same height, up to 0.5 mm beside them");
}

TEST_F(DicomGroups, RadiographsAreViews)
{
  for (int view = 0; view < 2; ++view)
  {
    Elements elements = Slice(view);
    elements.erase(Position);
    elements[Modality] = Text("CS", "DX");
    elements[InstanceNumber] = Text("IS", std::to_string(view + 1));
    elements[0x00185101] = Text("CS", view == 0 ? "AP" : "LL");
    this->Write(std::to_string(view), elements);
  }
  EXPECT_EQ(this->Read()->GetDimensions()[2], 1);
  this->ExpectWarning("1 (view AP 1: \"0\"), 2 (view LL 2: \"1\")");
}

TEST_F(DicomGroups, UnevenSlicesAreDrawnAtTheirUsualDistance)
{
  this->WriteHeights({ 0.0, 2.5, 5.0, 7.5, 10.0, 15.0, 20.0 });
  EXPECT_EQ(this->Read()->GetDimensions()[2], 7);
  EXPECT_NEAR(this->reader->GetOutput()->GetSpacing()[2], 2.5, 1e-9);
  EXPECT_TRUE(this->reader->HasIrregularSlices());
  this->ExpectWarning("Slices are 2.5 to 5 mm apart");
}

TEST_F(DicomGroups, SlicesBesideTheLineOfTheOthersAreToldAndRectified)
{
  for (int i = 0; i < 3; ++i)
  {
    Elements elements = Slice(0, i);
    elements[Orientation] = Decimals({ 1, 0, 0, 0, 1, 0 });
    elements[Position] = Decimals({ i == 1 ? 9.0 : 0.0, 0, 2.0 * i });
    this->Write(std::to_string(i), elements);
  }
  this->Read();
  this->ExpectWarning("Slices lie up to 9 mm beside the straight line");
  EXPECT_TRUE(this->reader->HasIrregularSlices());
}

TEST_F(DicomGroups, WithoutPositionsSlicesAreOrderedByTheirLocations)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    elements.erase(Position);
    elements.erase(Orientation);
    elements[SliceLocation] = Decimals({ 4.0 * slice - 100.0 });
    this->Write(std::to_string(slice), elements);
  }
  vtkImageData* const image = this->Read();
  EXPECT_NEAR(image->GetSpacing()[2], 4.0, 1e-9);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 2, 2, 0), phantom::ValueAt({ 1, 2, 2 }));
  this->ExpectWarning("which side is the patient's left");
}

TEST_F(DicomGroups, OnePositionForAllSlicesIsNotBelieved)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    elements[Position] = Decimals({ 1, 2, 3 });
    elements[SliceLocation] = Decimals({ 4.0 * slice });
    this->Write(std::to_string(slice), elements);
  }
  EXPECT_NEAR(this->Read()->GetSpacing()[2], 4.0, 1e-9);
  EXPECT_EQ(this->reader->GetOutput()->GetDimensions()[2], 3);
  this->ExpectWarning("All images state the same position");
}

TEST_F(DicomGroups, TheThicknessStandsInForAnUnknownDistance)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    elements.erase(Position);
    elements[InstanceNumber] = Text("IS", std::to_string(slice));
    elements[SliceThickness] = Decimals({ 3.5 });
    this->Write(std::to_string(slice), elements);
  }
  EXPECT_NEAR(this->Read()->GetSpacing()[2], 3.5, 1e-9);
  this->ExpectWarning("their thickness was taken");
}

}
