#ifndef Varimarch_Readers_Segmentation_h
#define Varimarch_Readers_Segmentation_h

#include "Readers/Dicom/DicomSeries.h"
#include "Readers/VolumeFile.h"

namespace varimarch
{

/// True for a series of segmentations (PS3.3 A.51), whose frames are the masks of segments, or
/// labels.
bool IsSegmentation(const DicomSeries& series);

/// Reads a segmentation as labels: the value of a voxel is the number of its segment, or 0. Frames
/// lie where they say, and what has no frame has no segment. Where segments overlap, the one of the
/// highest number wins. Of several files only the first is read.
/// @param path  path for error messages
/// @throws std::runtime_error if frames have no positions, or do not form a volume
/// @throws ReadCancelled
Volume ReadSegmentation(const std::string& path, const DicomSeries& series, ReadProgress& progress);

}

#endif
