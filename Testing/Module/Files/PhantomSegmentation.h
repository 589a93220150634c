#ifndef Varimarch_Testing_PhantomSegmentation_h
#define Varimarch_Testing_PhantomSegmentation_h

#include "PhantomDicom.h"

#include <string>
#include <vector>

/// DICOM segmentations, written according to PS3.3 A.51 without any library.
namespace phantom_dicom
{

/// A segment as a segmentation describes it.
struct DescribedSegment
{
  int number;
  std::string label;
  std::vector<int> lab = {}; ///< colour as PS3.3 C.10.7.1.1 has it; empty: none
};

/// A mask of a slice.
struct SegmentFrame
{
  int segment; ///< number of the segment; 0 if the pixels are labels
  int slice;
  std::vector<int> pixels; ///< row by row
};

enum class SegmentationType
{
  Binary,
  Fractional, ///< 200 is the whole voxel
  Labels
};

/// A segmentation on the grid of a volume, whose values do not matter.
Elements Segmentation(const StoredVolume& grid, const std::vector<DescribedSegment>& segments,
  const std::vector<SegmentFrame>& frames, SegmentationType type = SegmentationType::Binary);

/// The geometry that all frames share.
/// @param hasDistance  false if only the thickness of the slices is stated, not their distance
Element SharedItems(const StoredVolume& grid, bool hasDistance = true);

}

#endif
