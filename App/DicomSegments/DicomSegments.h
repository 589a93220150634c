#ifndef Varimarch_DicomSegments_DicomSegments_h
#define Varimarch_DicomSegments_DicomSegments_h

#include "Scene/Segments/LabelMap.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Writes the segments of a scan as a binary DICOM segmentation (PS3.3 A.51) with their names and
/// colours, of the scan's patient and study, in its frame of reference. Segments are numbered from
/// 1 on in their order. Frames without voxels are left out.
/// @param segments  of the labels, with the names and colours to write
/// @param images    files of the scan's DICOM series, at least one; none is ever replaced
/// @throws std::runtime_error with one sentence if there are no voxels, an image cannot be read, or
///         the file cannot be written
void WriteDicomSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const std::vector<std::string>& images, const std::string& path);

}

#endif
