#ifndef Varimarch_Scene_SliceSegments_h
#define Varimarch_Scene_SliceSegments_h

#include "Scene/SlicePicture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace varimarch
{

using Rgba = std::array<std::uint8_t, 4>; ///< not premultiplied

/// The segments of a label map in a slice, to be laid over SlicePicture: pixels row by row from the
/// upper left. A visible segment is an opaque outline around a light fill, which is the lighter the
/// less opaque the segment is; everything else is transparent. Voxels have hard borders. A slab
/// shows the segments of its middle.
/// @param numbers   as LabelMap::image
/// @param segments  as many as the label map has, in their order
std::vector<Rgba> SliceSegments(
  vtkImageData* numbers, const std::vector<Segment>& segments, const SliceRequest& request);

}

#endif
