#ifndef Varimarch_Readers_Dicom_UptakeValue_h
#define Varimarch_Readers_Dicom_UptakeValue_h

#include "Readers/Dicom/Attributes.h"

#include <optional>
#include <string>

namespace varimarch
{

/// The standardized uptake values (SUV) of an image.
struct UptakeValue
{
  std::optional<double> factor; ///< from values to SUV by body weight [g/ml]
  std::string doubt; ///< the reason why a PET image has no factor, as the end of a sentence
};

/// Determines the factor to standardized uptake values of a PET image as QIBA's profile for FDG
/// computes it (QIBA, "SUV vendor-neutral pseudo-code", 2012): values in Bq/ml times the patient's
/// weight, divided by the dose that was left at the start of the scan. Values that are SUV by body
/// weight already have the factor 1, and those of Philips' counts the factor that the file gives.
/// There is no factor where the file does not say what is needed, or what it says cannot be true.
/// Both members are empty for other modalities.
UptakeValue UptakeValueOf(const DicomAttributes& attributes);

}

#endif
