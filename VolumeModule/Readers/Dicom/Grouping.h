#ifndef Varimarch_Readers_Dicom_Grouping_h
#define Varimarch_Readers_Dicom_Grouping_h

#include "Readers/Dicom/DicomFrame.h"

namespace varimarch
{

/// The slices of one volume.
struct DicomSlices
{
  std::vector<DicomFrame> frames; ///< in order along their normal, each at a place of its own
  std::vector<double> heightsMm;  ///< heights of the frames along the normal, in ascending order
  bool hasPositions = false;      ///< true if the files state the positions of the slices
};

/// Chooses the frames of a series that make up one volume: those of the most frequent size,
/// direction and pixel size, of the first complete set of images that the files distinguish, and
/// one for each place. Repeats of a place are other times, echoes or kinds of image only if an
/// attribute says so.
/// @param frames  in the order of their numbers; at least one
/// @param warnings  receives a sentence about all that is left out
DicomSlices ChooseSlices(std::vector<DicomFrame> frames, std::vector<std::string>& warnings);

/// The median distance of consecutive slices; a few gaps do not change it.
/// @param heightsMm  at least two, in ascending order
double UsualDistanceMm(const std::vector<double>& heightsMm);

}

#endif
