#ifndef Varimarch_Readers_Dicom_UptakeValue_h
#define Varimarch_Readers_Dicom_UptakeValue_h

#include "Readers/Dicom/Attributes.h"

#include <optional>

namespace varimarch
{

/// The factor from the values of a PET image to standardized uptake values by body weight [g/ml],
/// as QIBA's profile for FDG computes it (QIBA, "SUV vendor-neutral pseudo-code", 2012): values in
/// Bq/ml times the patient's weight, divided by the dose that was left at the start of the scan.
/// Values that are SUV already have the factor 1, and those of Philips' counts the factor that the
/// file gives. Empty for other modalities, and where the file does not say what is needed: its
/// values are not corrected for attenuation and decay, or the start of the scan is uncertain.
std::optional<double> UptakeValueFactor(const DicomAttributes& attributes);

}

#endif
