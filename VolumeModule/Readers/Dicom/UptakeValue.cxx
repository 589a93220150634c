#include "Readers/Dicom/UptakeValue.h"

#include "Readers/Dicom/Moment.h"
#include "Readers/FileError.h"
#include "Readers/NumberText.h"

#include <vtkDICOMDictHash.h>

#include <cmath>

namespace varimarch
{
namespace
{

constexpr double SecondsPerDay = 86400.0;
const vtkDICOMTag PhilipsSuvFactor(0x7053, 0x1000);

// Numbers beyond these are in another unit, or have been changed by a program that removes names:
// after 12 half-lives a tracer is hardly measurable.
constexpr double MostHalfLives = 12.0;
constexpr double LeastDoseBq = 1e5;
constexpr double MostDoseBq = 1e11;
constexpr double MostWeightKg = 700.0;

/// Thrown with the reason why there is no factor.
struct Doubt
{
  std::string reason;
};

void Require(bool isTrue, const std::string& otherwise)
{
  if (!isTrue)
  {
    throw Doubt{ otherwise };
  }
}

vtkDICOMTagPath OfTracer(vtkDICOMTag tag)
{
  return { DC::RadiopharmaceuticalInformationSequence, 0, tag };
}

/// The start of the scan, in the local time of the file [s].
double StartOfScan(const DicomAttributes& attributes)
{
  const auto scan =
    SecondsOfMoment(attributes.Text(DC::SeriesDate), attributes.Text(DC::SeriesTime));
  const auto acquired =
    SecondsOfMoment(attributes.Text(DC::AcquisitionDate), attributes.Text(DC::AcquisitionTime));
  Require(scan && acquired, "the file does not say when the scan began");
  Require(*scan <= *acquired, "the series is younger than its images, so it was computed later");
  return *scan;
}

/// The moment of the injection as the file states it with its date, in the local time of the file.
/// Empty if it does not, or in a time zone while that of the file is unknown.
std::optional<double> DatedInjection(const DicomAttributes& attributes)
{
  const std::string whole = attributes.Text(OfTracer(DC::RadiopharmaceuticalStartDateTime));
  const auto moment =
    whole.size() > 8 ? SecondsOfMoment(whole.substr(0, 8), whole.substr(8)) : std::nullopt;
  const auto zone = SecondsOfZone(whole);
  if (!moment || !zone)
  {
    return moment;
  }
  const auto zoneOfFile = SecondsOfZone(attributes.Text(DC::TimezoneOffsetFromUTC));
  return zoneOfFile ? std::optional(*moment - *zone + *zoneOfFile) : std::nullopt;
}

/// The time from the injection to the start of the scan [s].
double DecaySeconds(const DicomAttributes& attributes)
{
  const double scan = StartOfScan(attributes);
  const auto dated = DatedInjection(attributes);
  const auto injected = dated ? dated
                              : SecondsOfMoment(attributes.Text(DC::SeriesDate),
                                  attributes.Text(OfTracer(DC::RadiopharmaceuticalStartTime)));
  Require(injected.has_value(), "the file does not say when the tracer was injected");
  // A time without a date may be that of the day before.
  const double elapsed = scan - *injected + (!dated && *injected > scan ? SecondsPerDay : 0.0);
  Require(elapsed >= 0.0, "the tracer was injected after the scan had begun");
  return elapsed;
}

/// The dose to which the values refer [Bq].
double ReferenceDose(const DicomAttributes& attributes)
{
  const double dose = attributes.Number(OfTracer(DC::RadionuclideTotalDose)).value_or(0.0);
  const std::string correction = attributes.Text(DC::DecayCorrection);
  Require(dose > 0.0, "the file does not say the dose");
  Require(dose >= LeastDoseBq && dose <= MostDoseBq,
    "a dose of " + ShortText(dose) + " Bq cannot be true");
  Require(correction == "START" || correction == "ADMIN",
    "the file does not say to which moment its values are corrected");
  if (correction == "ADMIN")
  {
    return dose;
  }
  const double halfLife = attributes.Number(OfTracer(DC::RadionuclideHalfLife)).value_or(0.0);
  Require(halfLife > 0.0, "the file does not say the half-life of the tracer");
  const double halfLives = DecaySeconds(attributes) / halfLife;
  Require(halfLives <= MostHalfLives,
    "the tracer was injected " + ShortText(halfLives) +
      " half-lives before the scan, which cannot be true");
  return dose * std::exp2(-halfLives);
}

double WeightKg(const DicomAttributes& attributes)
{
  const double weightKg = attributes.NumberOr(DC::PatientWeight, 0.0);
  Require(weightKg > 0.0, "the file does not say the weight of the patient");
  Require(weightKg <= MostWeightKg, "a weight of " + ShortText(weightKg) + " kg cannot be true");
  return weightKg;
}

double FactorOf(const DicomAttributes& attributes)
{
  constexpr double GramsPerKg = 1000.0;
  const std::string units = attributes.Text(DC::Units);
  if (units == "GML")
  {
    const std::string type = attributes.Text(DC::SUVType);
    Require(
      type.empty() || type == "BW", "its values are not by body weight, but by " + Quoted(type));
    return 1.0;
  }
  const std::string corrections = attributes.Text(DC::CorrectedImage);
  Require(
    corrections.find("ATTN") != std::string::npos && corrections.find("DECY") != std::string::npos,
    "its values are not corrected for attenuation and decay");
  if (units == "CNTS")
  {
    const double factor = attributes.NumberOr(PhilipsSuvFactor, 0.0);
    Require(factor > 0.0, "its values are counts without a factor");
    return factor;
  }
  Require(units == "BQML",
    units.empty() ? "the file does not say the unit of its values"
                  : "its values are in the unit " + Quoted(units));
  return GramsPerKg * WeightKg(attributes) / ReferenceDose(attributes);
}

}

UptakeValue UptakeValueOf(const DicomAttributes& attributes)
{
  if (attributes.Text(DC::Modality) != "PT")
  {
    return {};
  }
  try
  {
    return { FactorOf(attributes), "" };
  }
  catch (const Doubt& doubt)
  {
    return { std::nullopt, doubt.reason };
  }
}

}
