#ifndef Varimarch_Scene_SegmentFiles_h
#define Varimarch_Scene_SegmentFiles_h

#include "Scene/LabelMap.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Refuses to replace a file of a scan.
/// @throws std::runtime_error with one sentence if the path is the file of a scan, or an existing
///         file in the folder of one
void RequireNoFileOf(const std::vector<VolumeSource>& scans, const std::string& path);

/// Writes the segments of a scan as a label map on its grid: a ".seg.nrrd" of 3D Slicer with names
/// and colours, or NIfTI (".nii", ".nii.gz") with the values alone.
/// @param segments  of the labels, with the names and colours to write
/// @param scans     sources of the volume and of those over it, whose files are never replaced
/// @return sentences about what the format does not hold
/// @throws std::runtime_error with one sentence for another extension, for the file of a scan, or
/// if
///         the file cannot be written
std::vector<std::string> WriteSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const std::vector<VolumeSource>& scans, const std::string& path);

}

#endif
