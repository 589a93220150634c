#ifndef Varimarch_Readers_Dicom_Segmentation_h
#define Varimarch_Readers_Dicom_Segmentation_h

#include "Readers/VolumeFile.h"

namespace varimarch
{

/// Reads the segmentation in a file as labels: the value of a voxel is the number of its segment,
/// or 0. Frames lie where they say, and what has no frame has no segment; but frames of a scan
/// whose slices have two distances reach half way to the next. Where segments overlap, the one of
/// the highest number wins.
/// @throws std::runtime_error if frames have no positions, or do not form a volume
/// @throws ReadCancelled
Volume ReadSegmentation(const std::string& path, ReadProgress& progress);

}

#endif
