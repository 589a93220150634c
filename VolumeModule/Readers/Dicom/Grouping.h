#ifndef Varimarch_Readers_Dicom_Grouping_h
#define Varimarch_Readers_Dicom_Grouping_h

#include "Readers/Dicom/Differences.h"
#include "Readers/VolumeFile.h"

namespace varimarch
{

/// The slices of one volume.
struct DicomSlices
{
  std::vector<DicomFrame> frames; ///< in order along their normal, each at a place of its own
  std::vector<double> heightsMm;  ///< heights of the frames along the normal, in ascending order
  bool hasPositions = false;      ///< true if the files state the positions of the slices
};

/// The frames of all times of a series.
struct DicomVolumes
{
  std::vector<std::vector<PlacedFrame>> sets; ///< one for each time
  VolumeTimes times;
  bool hasPositions = false; ///< true if the files state the positions of the slices
};

/// Chooses the frames of a series that make up volumes: those of the most frequent size, direction
/// and pixel size, and of the first complete set of images that the files distinguish, at each
/// time. Repeats of a place are other times, echoes or kinds of image only if an attribute says so.
/// @param frames  in the order of their numbers; at least one
/// @param warnings  receives a sentence about all that is left out
DicomVolumes VolumesOf(std::vector<DicomFrame> frames, std::vector<std::string>& warnings);

/// The slices of one time: one frame for each place.
DicomSlices SlicesOf(
  const DicomVolumes& volumes, std::int64_t time, std::vector<std::string>& warnings);

/// The median distance of consecutive slices; a few gaps do not change it.
/// @param heightsMm  at least two, in ascending order
double UsualDistanceMm(const std::vector<double>& heightsMm);

}

#endif
