#include "Readers/Dicom/UptakeValue.h"

#include "Readers/Dicom/Moment.h"

#include <vtkDICOMDictHash.h>

#include <cmath>
#include <string>

namespace varimarch
{
namespace
{

constexpr double SecondsPerDay = 86400.0;
constexpr double LongestDecayDays = 30.0; // a longer one is an error of dates
const vtkDICOMTag PhilipsSuvFactor(0x7053, 0x1000);

vtkDICOMTagPath OfTracer(vtkDICOMTag tag)
{
  return { DC::RadiopharmaceuticalInformationSequence, 0, tag };
}

/// The time from the injection to the start of the scan [s].
std::optional<double> DecaySeconds(const DicomAttributes& attributes)
{
  const std::string scanDate = attributes.Text(DC::SeriesDate);
  const auto scan = SecondsOfMoment(scanDate, attributes.Text(DC::SeriesTime));
  const auto acquired =
    SecondsOfMoment(attributes.Text(DC::AcquisitionDate), attributes.Text(DC::AcquisitionTime));
  // A series that begins after its images has been computed later.
  if (!scan || !acquired || *scan > *acquired)
  {
    return std::nullopt;
  }
  const std::string whole = attributes.Text(OfTracer(DC::RadiopharmaceuticalStartDateTime));
  const auto injected = whole.size() > 8
    ? SecondsOfMoment(whole.substr(0, 8), whole.substr(8))
    : SecondsOfMoment(scanDate, attributes.Text(OfTracer(DC::RadiopharmaceuticalStartTime)));
  if (!injected)
  {
    return std::nullopt;
  }
  // A time without a date may be that of the day before.
  const double elapsed =
    *scan - *injected + (whole.empty() && *injected > *scan ? SecondsPerDay : 0.0);
  return elapsed >= 0.0 && elapsed < LongestDecayDays * SecondsPerDay ? std::optional(elapsed)
                                                                      : std::nullopt;
}

/// The dose to which the values refer [Bq].
std::optional<double> ReferenceDose(const DicomAttributes& attributes)
{
  const auto dose = attributes.Number(OfTracer(DC::RadionuclideTotalDose));
  const std::string correction = attributes.Text(DC::DecayCorrection);
  if (!dose || *dose <= 0.0 || (correction != "START" && correction != "ADMIN"))
  {
    return std::nullopt;
  }
  if (correction == "ADMIN")
  {
    return dose;
  }
  const auto halfLife = attributes.Number(OfTracer(DC::RadionuclideHalfLife));
  const auto elapsed = DecaySeconds(attributes);
  return halfLife && *halfLife > 0.0 && elapsed
    ? std::optional(*dose * std::exp2(-*elapsed / *halfLife))
    : std::nullopt;
}

}

std::optional<double> UptakeValueFactor(const DicomAttributes& attributes)
{
  const std::string units = attributes.Text(DC::Units);
  if (attributes.Text(DC::Modality) != "PT")
  {
    return std::nullopt;
  }
  if (units == "GML")
  {
    return 1.0;
  }
  const std::string corrections = attributes.Text(DC::CorrectedImage);
  const bool isCorrected =
    corrections.find("ATTN") != std::string::npos && corrections.find("DECY") != std::string::npos;
  if (!isCorrected)
  {
    return std::nullopt;
  }
  if (units == "CNTS")
  {
    const auto factor = attributes.Number(PhilipsSuvFactor);
    return factor && *factor > 0.0 ? factor : std::nullopt;
  }
  const auto weightKg = attributes.Number(DC::PatientWeight);
  const auto dose = ReferenceDose(attributes);
  return units == "BQML" && weightKg && *weightKg > 0.0 && dose
    ? std::optional(1000.0 * *weightKg / *dose)
    : std::nullopt;
}

}
