#ifndef Varimarch_Readers_Dicom_AlikeFrames_h
#define Varimarch_Readers_Dicom_AlikeFrames_h

#include "Readers/Dicom/DicomFrame.h"

namespace varimarch
{

/// Frames that may be slices of one volume.
struct AlikeFrames
{
  std::string name; ///< their difference from the others: "10 x 6 pixels, sagittal"; or empty
  std::vector<DicomFrame> frames;
};

/// Frames of a series by what slices of one volume share: their size, direction, pixel size,
/// whether they have positions, and the station of a moving table. Frames at the same height belong
/// to several stations if they lie more than a quarter of an image beside each other.
/// @param frames  at least one
/// @returns at least one group; most frames first at each step of the division
std::vector<AlikeFrames> GroupsOfAlike(const std::vector<DicomFrame>& frames);

}

#endif
