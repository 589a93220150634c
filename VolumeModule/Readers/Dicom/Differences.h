#ifndef Varimarch_Readers_Dicom_Differences_h
#define Varimarch_Readers_Dicom_Differences_h

#include "Readers/Dicom/DicomFrame.h"

namespace varimarch
{

/// A frame and its place in a stack.
struct PlacedFrame
{
  DicomFrame frame;
  double heightMm; ///< along the normal
  int place;       ///< equal for frames at the same place
};

/// Separates frames that repeat places by the attributes that tell them apart, and returns the
/// complete sets of all times, in their order, for the first echo and kind of image. An attribute
/// separates sets only if these lie over each other, or most of them over the largest; the parts of
/// a stack that were acquired one after the other stay together.
/// @param frames  in the order of their numbers; at least one
/// @param warnings  receives a sentence about each attribute by which frames are left out
std::vector<std::vector<PlacedFrame>> SetsOfTimes(
  const std::vector<PlacedFrame>& frames, std::vector<std::string>& warnings);

}

#endif
