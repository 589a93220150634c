#ifndef Varimarch_Readers_NrrdSegments_h
#define Varimarch_Readers_NrrdSegments_h

#include "Readers/NrrdAxes.h"
#include "Readers/NrrdHeader.h"
#include "Readers/VolumeFile.h"

namespace varimarch
{

// Segmentations of 3D Slicer (.seg.nrrd): label maps whose key/value pairs describe the segments.
// Segments that overlap are in several layers, along a list axis.

/// True if a header describes segments.
bool HoldsSegments(const NrrdHeader& header);

/// The axes of a segmentation: layers are the components of a voxel.
NrrdAxes LayersAsComponents(const NrrdAxes& axes);

/// Takes the segments, and makes labels of the layers: with several layers a voxel's value is the
/// number of its segment, counted from 1. Where segments overlap, the later one wins.
void TakeSegments(const NrrdHeader& header, Volume& volume);

}

#endif
