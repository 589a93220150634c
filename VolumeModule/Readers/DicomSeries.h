#ifndef Varimarch_Readers_DicomSeries_h
#define Varimarch_Readers_DicomSeries_h

#include "Readers/VolumeFile.h"

#include <vtkStringArray.h>

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The files of a DICOM series: one scan of a patient.
struct DicomSeries
{
  std::string uid;
  std::string description; ///< as the scanner's operator entered it, or empty
  std::string modality;    ///< such as "CT" or "MR"
  std::int64_t imageCount; ///< number of files, or of frames in multi-frame files
  vtkSmartPointer<vtkStringArray> files;
};

/// Finds the series with images in a folder and its subfolders, in a DICOMDIR, or in a single file,
/// those with most images first.
/// @param warnings  receives sentences about files that could not be read
/// @throws std::runtime_error if there are none, or a file promises more than it holds
/// @throws ReadCancelled
std::vector<DicomSeries> FindDicomSeries(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

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
