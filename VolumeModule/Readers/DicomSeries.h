#ifndef Varimarch_Readers_DicomSeries_h
#define Varimarch_Readers_DicomSeries_h

#include "Readers/VolumeFile.h"

#include <vtkStringArray.h>

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// One scan of a patient: the files of a DICOM series.
struct DicomSeries
{
  std::string uid;
  std::string description; ///< as the scanner's operator named it, or empty
  std::string modality;    ///< "CT", "MR" ...
  std::int64_t imageCount; ///< files, or frames of files with several
  vtkSmartPointer<vtkStringArray> files;
};

/// The series with images in a folder and the folders in it, in a DICOMDIR, or in a single file;
/// those with most images first.
/// @param warnings  gets sentences about files that could not be read
/// @throws std::runtime_error when there are none, or a file promises more than it holds
/// @throws ReadCancelled
std::vector<DicomSeries> FindDicomSeries(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress);

/// The series that a text names: by its number, from 1, by its UID, or by the beginning of just one
/// UID; the first where the text is empty.
/// @param path  for the message
/// @throws std::runtime_error that lists them when it names none, or several
const DicomSeries& SeriesNamed(
  const std::string& path, const std::vector<DicomSeries>& all, const std::string& name);

/// "1 (CT, 96 images, Thorax, 1.2.840.1), 2 (MR, ...)"
std::string SeriesList(const std::vector<DicomSeries>& all);

}

#endif
