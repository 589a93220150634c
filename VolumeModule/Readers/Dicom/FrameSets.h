#ifndef Varimarch_Readers_Dicom_FrameSets_h
#define Varimarch_Readers_Dicom_FrameSets_h

#include "Readers/Dicom/DicomFrame.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// A frame and its place in a stack.
struct PlacedFrame
{
  DicomFrame frame;
  double heightMm; ///< along the normal
  int place;       ///< equal for frames at the same place
};

using FrameSet = std::vector<PlacedFrame>;

/// The number of places at which frames lie.
std::size_t PlaceCount(const FrameSet& frames);

/// The number of places of the largest set; 0 if there are no sets.
std::size_t MostPlaces(const std::vector<FrameSet>& sets);

/// The largest number of frames at one place.
std::size_t MostRepeats(const FrameSet& frames);

/// True if frames have different values of an attribute.
/// @param difference  the index of a DicomDifference
bool Varies(std::size_t difference, const FrameSet& frames);

/// The sets that an attribute separates; none if it separates no volumes. They are in ascending
/// order if all values are numbers, otherwise in the order of their first frames.
/// @param difference  the index of a DicomDifference
/// @param frames  at least one
std::vector<FrameSet> VolumesBy(std::size_t difference, const FrameSet& frames);

}

#endif
