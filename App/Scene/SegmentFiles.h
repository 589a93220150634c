#ifndef Varimarch_Scene_SegmentFiles_h
#define Varimarch_Scene_SegmentFiles_h

#include "Scene/LabelMap.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Writes the segments of a scan as a label map on its grid: a ".seg.nrrd" of 3D Slicer with names
/// and colours, or NIfTI (".nii", ".nii.gz") with the values alone.
/// @param segments  of the labels, with the names and colours to write
/// @param scan      the volume's own source, whose file is never replaced
/// @return sentences about what the format does not hold
/// @throws std::runtime_error with one sentence for another extension, for the file of the scan, or
///         if the file cannot be written
std::vector<std::string> WriteSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const VolumeSource& scan, const std::string& path);

}

#endif
