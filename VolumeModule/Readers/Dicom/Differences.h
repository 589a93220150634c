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
/// first complete set: one time, echo, or kind of image. An attribute separates sets only if these
/// lie over each other, or most of them over the largest; the parts of a stack that were acquired
/// one after the other stay together.
/// @param frames  in the order of their numbers; at least one
/// @param warnings  receives a sentence about each attribute that separates sets
std::vector<PlacedFrame> FirstCompleteSet(
  std::vector<PlacedFrame> frames, std::vector<std::string>& warnings);

}

#endif
