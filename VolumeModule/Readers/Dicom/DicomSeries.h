#ifndef Varimarch_Readers_Dicom_DicomSeries_h
#define Varimarch_Readers_Dicom_DicomSeries_h

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/VolumeFile.h"

namespace varimarch
{

/// The images of a DICOM series: one scan of a patient.
struct DicomSeries
{
  std::string uid;
  std::string description; ///< as the scanner's operator entered it, or empty
  std::string modality;    ///< such as "CT" or "MR"
  double number = 0.0;
  std::vector<DicomFrame> frames; ///< in the order of their numbers, then of their files
};

/// True for a series of segmentations (PS3.3 A.51), whose frames are the masks of segments, or
/// labels.
bool IsSegmentation(const DicomSeries& series);

/// The series below a path.
struct DicomScan
{
  std::vector<DicomSeries> series; ///< at least one; most images first, segmentations last
  std::vector<DicomFault> faults;  ///< files that cannot be read, wholly or in part
  std::vector<std::string> warnings;
};

/// Finds the series with images in a folder and its subfolders, in a DICOMDIR, or in a single file.
/// @throws std::runtime_error if there are none
/// @throws ReadCancelled
DicomScan FindDicomSeries(const std::string& path, ReadProgress& progress);

/// The series with the given name: its number, counted from 1, its UID, or an unambiguous prefix of
/// its UID. An empty name selects the first series.
/// @param path  path for the error message
/// @throws std::runtime_error, with a list of all series, if the name selects none or several
const DicomSeries& SeriesNamed(
  const std::string& path, const std::vector<DicomSeries>& all, const std::string& name);

/// A text such as "1 (CT, 96 images, Thorax, 1.2.840.1), 2 (MR, ...)".
std::string SeriesList(const std::vector<DicomSeries>& all);

}

#endif
