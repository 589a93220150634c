#ifndef Varimarch_Readers_Dicom_Differences_h
#define Varimarch_Readers_Dicom_Differences_h

#include "Readers/Dicom/FrameSets.h"

namespace varimarch
{

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

}

#endif
