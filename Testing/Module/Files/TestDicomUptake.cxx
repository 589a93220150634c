// Standardized uptake values of PET, with factors that are computed by hand.
#include "DicomReading.h"
#include "DicomTags.h"

namespace
{

using phantom_dicom::Decimals;
using phantom_dicom::Elements;
using phantom_dicom::Sequence;
using phantom_dicom::Text;
using namespace dicom_tags;

constexpr std::uint32_t Weight = 0x00101030;
constexpr std::uint32_t Units = 0x00541001;
constexpr std::uint32_t DecayCorrection = 0x00541102;
constexpr std::uint32_t Corrections = 0x00280051;
constexpr std::uint32_t Tracer = 0x00540016;
constexpr std::uint32_t SeriesTime = 0x00080031;
constexpr std::uint32_t StartTime = 0x00181072;
constexpr std::uint32_t StartDateTime = 0x00181078;
constexpr std::uint32_t Dose = 0x00181074;
constexpr std::uint32_t HalfLife = 0x00181075;

// 400 MBq of a tracer with a half-life of an hour, an hour before the scan: 200 MBq are left. 80 kg
// are 80000 g, so the factor is 80000 / 2e8 = 4e-4 g/Bq.
class DicomUptake : public DicomReading
{
protected:
  static Elements Pet(const Elements& tracer = {})
  {
    Elements elements = Slice(0);
    elements[Modality] = Text("CS", "PT");
    elements[0x00080021] = Text("DA", "20260102");
    elements[0x00080022] = Text("DA", "20260102");
    elements[SeriesTime] = Text("TM", "100000");
    elements[0x00080032] = Text("TM", "100130.5");
    elements[Weight] = Decimals({ 80 });
    elements[Units] = Text("CS", "BQML");
    elements[DecayCorrection] = Text("CS", "START");
    elements[Corrections] = Text("CS", "DECY\\ATTN\\SCAT");
    Elements all = tracer;
    all.insert({ StartTime, Text("TM", "090000.00") });
    all.insert({ Dose, Decimals({ 4e8 }) });
    all.insert({ HalfLife, Decimals({ 3600 }) });
    elements[Tracer] = Sequence({ all });
    return elements;
  }

  /// The factor; 0 if there is none.
  double FactorOf(const Elements& elements)
  {
    this->Write("pet.dcm", elements);
    this->Read("pet.dcm");
    return this->reader->GetUptakeValueFactor();
  }
};

}

TEST_F(DicomUptake, IsByWeightAndTheDoseLeftAtTheStartOfTheScan)
{
  EXPECT_NEAR(this->FactorOf(Pet()), 4e-4, 1e-12);
}

TEST_F(DicomUptake, RefersToTheInjectedDoseIfValuesAreCorrectedToTheInjection)
{
  Elements elements = Pet();
  elements[DecayCorrection] = Text("CS", "ADMIN");
  EXPECT_NEAR(this->FactorOf(elements), 2e-4, 1e-12);
}

// Two half-lives from 23:30 to 01:30.
TEST_F(DicomUptake, CountsAcrossMidnight)
{
  Elements elements = Pet({ { StartTime, Text("TM", "233000") } });
  elements[SeriesTime] = Text("TM", "013000");
  EXPECT_NEAR(this->FactorOf(elements), 8e-4, 1e-12);
  elements = Pet({ { StartDateTime, Text("DT", "20260102060000.00") } });
  EXPECT_NEAR(this->FactorOf(elements), 32e-4, 1e-12); // four half-lives
}

TEST_F(DicomUptake, IsTheValueWhereTheFileSaysSo)
{
  Elements elements = Pet();
  elements[Units] = Text("CS", "GML");
  EXPECT_EQ(this->FactorOf(elements), 1.0);
}

// 08:00 in UTC is 09:00 in the zone of the file.
TEST_F(DicomUptake, CountsInOneTimeZone)
{
  Elements elements = Pet({ { StartDateTime, Text("DT", "20260102080000.00+0000") } });
  elements[0x00080201] = Text("SH", "+0100");
  EXPECT_NEAR(this->FactorOf(elements), 4e-4, 1e-12);
  // Without the zone of the file, the time of day counts.
  elements.erase(0x00080201);
  EXPECT_NEAR(this->FactorOf(elements), 4e-4, 1e-12);
}

TEST_F(DicomUptake, IsUnknownWhereWhatTheFileSaysCannotBeTrue)
{
  const auto expectDoubt = [this](const Elements& elements, const std::string& reason)
  {
    EXPECT_EQ(this->FactorOf(elements), 0.0);
    this->ExpectWarning("Standardized uptake values are unknown: " + reason + ".");
  };
  expectDoubt(Pet({ { StartDateTime, Text("DT", "20251231090000.00") } }),
    "the tracer was injected 49 half-lives before the scan, which cannot be true");
  expectDoubt(Pet({ { StartDateTime, Text("DT", "20260103090000.00") } }),
    "the tracer was injected after the scan had begun");
  expectDoubt(Pet({ { Dose, Decimals({ 400 }) } }), "a dose of 400 Bq cannot be true");
  Elements grams = Pet();
  grams[Weight] = Decimals({ 80000 });
  expectDoubt(grams, "a weight of 8e+04 kg cannot be true");
  Elements lean = Pet();
  lean[Units] = Text("CS", "GML");
  lean[0x00541006] = Text("CS", "LBM");
  expectDoubt(lean, "its values are not by body weight, but by \"LBM\"");
}

TEST_F(DicomUptake, IsUnknownWhereSomethingIsMissing)
{
  for (const std::uint32_t missing :
    { Weight, Units, DecayCorrection, Corrections, Tracer, SeriesTime })
  {
    Elements elements = Pet();
    elements.erase(missing);
    EXPECT_EQ(this->FactorOf(elements), 0.0) << std::hex << missing;
  }
  Elements computedLater = Pet();
  computedLater[SeriesTime] = Text("TM", "110000");
  EXPECT_EQ(this->FactorOf(computedLater), 0.0);
  Elements ct = Pet();
  ct[Modality] = Text("CS", "CT");
  EXPECT_EQ(this->FactorOf(ct), 0.0);
}
