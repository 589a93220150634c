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

/// The frames of one kind of a series, at all times.
struct DicomVolumes
{
  std::string name;           ///< the difference from other kinds, such as "echo 20"; or empty
  std::vector<FrameSet> sets; ///< one for each time
  VolumeTimes times;
  bool hasPositions = false;         ///< true if the files state the positions of the slices
  std::vector<std::string> warnings; ///< sentences about the places and times of the frames
};

/// Separates the frames of a series into the volumes that they make up, of one or more times each:
/// by size, direction, pixel size and station, then by the attributes that tell images apart, then
/// at gaps so wide that what lies beyond them is another part of the body. Each frame belongs to
/// one kind.
/// @param frames  in the order of their numbers; at least one
/// @returns at least one kind; the first is that of most images among the most frequent ones
std::vector<DicomVolumes> KindsOf(const std::vector<DicomFrame>& frames);

/// A text such as "1 (echo 10: "a.dcm" and 3 others), 2 (echo 20: "b.dcm" and 3 others)".
std::string KindList(const std::vector<DicomVolumes>& kinds);

/// The slices of one time: one frame for each place.
DicomSlices SlicesOf(
  const DicomVolumes& volumes, std::int64_t time, std::vector<std::string>& warnings);

/// The median distance of consecutive slices; a few gaps do not change it.
/// @param heightsMm  at least two, in ascending order
double UsualDistanceMm(const std::vector<double>& heightsMm);

}

#endif
