#ifndef Varimarch_Readers_Dicom_Differences_h
#define Varimarch_Readers_Dicom_Differences_h

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/VolumeFile.h"

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

/// Frames of one kind, such as one echo.
struct FrameKind
{
  std::string name;           ///< the difference from other kinds: "echo 20, b-value 0"; or empty
  std::vector<FrameSet> sets; ///< one for each time, in their order; at least one
  std::vector<std::string> warnings = {}; ///< sentences about its times
};

/// Separates frames by the attributes that tell them apart, first into kinds, then into times. An
/// attribute separates sets if these lie over each other, or most of them over the largest: at the
/// same places, or between each other's slices, each evenly by itself. The parts of a stack that
/// were acquired one after the other, or in turns, stay together. Where all places repeat equally
/// often and no attribute has a value for each time, the times are those by rank at each place.
/// @param frames  in the order of their numbers; at least one
/// @returns complete kinds first; incomplete times are kinds of their own, at the end
std::vector<FrameKind> SeparatedKinds(const FrameSet& frames);

/// The times of volumes by a frame of each: those that the files state, else those after the R wave
/// of the heart, else those of acquisition or content, from the first on; numbers if none of these
/// ascend.
/// @param frames  at least one
VolumeTimes TimesOf(const std::vector<const DicomFrame*>& frames);

}

#endif
