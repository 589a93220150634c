#ifndef Varimarch_DicomMeasures_DicomMeasures_h
#define Varimarch_DicomMeasures_DicomMeasures_h

#include "Scene/Model/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

struct LoadedVolume;

/// Writes measurements and annotations of a scan as a DICOM Comprehensive 3D SR (PS3.3 A.35.13)
/// that follows the template Imaging Measurement Report (PS3.16, TID 1500): each is a measurement
/// group with its name, its numbers in units of UCUM, and its lines in the scan's frame of
/// reference. It is of the scan's patient and study, and refers to all its images.
/// @param images  files of the scan's DICOM series, at least one; none is ever replaced
/// @throws std::runtime_error with one sentence if the scan has no frame of reference, an image
///         cannot be read, or the file cannot be written
void WriteDicomMeasures(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<std::string>& images, const std::string& path);

}

#endif
