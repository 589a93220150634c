// The times of a DICOM series, by the attributes that tell its volumes apart.
#include "DicomReading.h"
#include "DicomTags.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>

namespace
{

class DicomTimes : public DicomReading
{
protected:
  /// Writes 3 volumes, whose values are 1000 apart, with an attribute that has a value for each.
  void WriteTimes(std::uint32_t attribute, const std::vector<phantom_dicom::Element>& ofTimes)
  {
    for (int time = 0; time < 3; ++time)
    {
      for (int slice = 0; slice < 3; ++slice)
      {
        phantom_dicom::Elements elements = Slice(slice, 10 * time);
        elements[dicom_tags::Intercept] = phantom_dicom::Decimals({ 1000.0 * time });
        elements[attribute] = ofTimes[std::size_t(time)];
        // Names in no order, so that only attributes can tell the times apart.
        this->Write(std::to_string((slice * 5 + time * 7) % 11), elements);
      }
    }
  }

  void ExpectTimes(const std::vector<double>& times, bool areSeconds)
  {
    for (const int time : { 0, 2, 1 })
    {
      this->reader->SetTimeIndex(time);
      this->Read();
      this->ExpectPhantom(1000.0 * time);
    }
    EXPECT_EQ(this->Warnings(), "");
    ASSERT_EQ(this->reader->GetNumberOfTimes(), int(times.size()));
    EXPECT_EQ(this->reader->HasTimesInSeconds(), areSeconds);
    for (int time = 0; time < int(times.size()); ++time)
    {
      EXPECT_NEAR(this->reader->GetTimeValue(time), times[std::size_t(time)], 1e-6);
    }
  }
};

TEST_F(DicomTimes, AreThoseAfterTheRWave)
{
  using phantom_dicom::Decimals;
  this->WriteTimes(0x00181060, { Decimals({ 12.5 }), Decimals({ 50 }), Decimals({ 87.5 }) });
  this->ExpectTimes({ 0.0125, 0.05, 0.0875 }, true);
}

TEST_F(DicomTimes, AreThoseOfAcquisition)
{
  using phantom_dicom::Text;
  this->WriteTimes(
    0x00080032, { Text("TM", "095958.5"), Text("TM", "100000.25"), Text("TM", "100101") });
  this->ExpectTimes({ 0.0, 1.75, 62.5 }, true);
}

TEST_F(DicomTimes, AreNumbersWithoutAClock)
{
  using phantom_dicom::Text;
  this->WriteTimes(dicom_tags::TimePoint, { Text("IS", "1"), Text("IS", "2"), Text("IS", "10") });
  this->ExpectTimes({ 0.0, 1.0, 2.0 }, false);
}

TEST_F(DicomTimes, OfEchoesAreNotTold)
{
  using phantom_dicom::Decimals;
  this->WriteTimes(0x00180081, { Decimals({ 10 }), Decimals({ 20 }), Decimals({ 30 }) });
  this->Read();
  this->ExpectPhantom();
  EXPECT_EQ(this->reader->GetNumberOfTimes(), 1);
  this->ExpectWarning("The series holds 3 kinds of volume, of which the first was read: 1 (echo "
                      "10: ");
}

TEST_F(DicomTimes, OfEachEchoCanBeRead)
{
  using phantom_dicom::Decimals;
  this->WriteTimes(0x00180081, { Decimals({ 10 }), Decimals({ 20 }), Decimals({ 30 }) });
  for (const int kind : { 3, 1, 2 })
  {
    this->reader->SetDICOMKind(kind);
    this->Read();
    this->ExpectPhantom(1000.0 * (kind - 1));
    EXPECT_EQ(this->Warnings(), "");
  }
  ASSERT_EQ(this->reader->GetNumberOfDICOMKinds(), 3);
  EXPECT_STREQ(this->reader->GetDICOMKindName(3), "echo 30");
  const ExpectedVtkErrors errors;
  this->reader->SetDICOMKind(4);
  this->Read();
  EXPECT_NE(std::string(this->reader->GetErrorMessage()).find("3: 1 (echo 10: "), std::string::npos)
    << this->reader->GetErrorMessage();
}

TEST_F(DicomTimes, GoOnAfterMidnight)
{
  using phantom_dicom::Text;
  const char* const dates[] = { "20260101", "20260101", "20260102" };
  const char* const clocks[] = { "235950", "235958", "000006" };
  for (int time = 0; time < 3; ++time)
  {
    for (int slice = 0; slice < 3; ++slice)
    {
      phantom_dicom::Elements elements = Slice(slice, 10 * time);
      elements[dicom_tags::Intercept] = phantom_dicom::Decimals({ 1000.0 * time });
      elements[0x00080022] = Text("DA", dates[time]);
      elements[0x00080032] = Text("TM", clocks[time]);
      this->Write(std::to_string((slice * 5 + time * 7) % 11), elements);
    }
  }
  this->ExpectTimes({ 0.0, 8.0, 16.0 }, true);
}

TEST_F(DicomTimes, AreThePhasesOfTheBreath)
{
  const auto percent = [](float number)
  {
    return phantom_dicom::Element{ "FL",
      std::string(reinterpret_cast<const char*>(&number), sizeof(number)) };
  };
  this->WriteTimes(0x00209245, { percent(0.0F), percent(50.0F), percent(100.0F) });
  this->ExpectTimes({ 0.0, 1.0, 2.0 }, false);
}

// Each slice of a cine scan has its own times after the R wave, so that no value is shared.
TEST_F(DicomTimes, AreThoseByRankWhereSlicesShareNoValue)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    for (int time = 0; time < 3; ++time)
    {
      phantom_dicom::Elements elements = Slice(slice, 10 * time);
      elements[dicom_tags::Intercept] = phantom_dicom::Decimals({ 1000.0 * time });
      elements[0x00181060] = phantom_dicom::Decimals({ time * (33.0 + slice) });
      elements[dicom_tags::InstanceNumber] =
        phantom_dicom::Text("IS", std::to_string(3 * slice + time));
      this->Write(std::to_string((slice * 5 + time * 7) % 11), elements);
    }
  }
  for (const int time : { 0, 2, 1 })
  {
    this->reader->SetTimeIndex(time);
    this->Read();
    this->ExpectPhantom(1000.0 * time);
  }
  ASSERT_EQ(this->reader->GetNumberOfTimes(), 3);
  EXPECT_NEAR(this->reader->GetTimeValue(2), 0.066, 1e-9);
  this->ExpectWarning(
    "Each place has 3 images, and no value tells which of different places belong "
    "together; they were taken for times in the order of their trigger time.");
}

}
