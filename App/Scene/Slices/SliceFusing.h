#ifndef Varimarch_Scene_SliceFusing_h
#define Varimarch_Scene_SliceFusing_h

#include "Scene/Slices/SlicePicture.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

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

/// A volume over the first one in slices.
struct FusedSlice
{
  SliceColors colors;
  double opacity; ///< [0, 1]; in a checkerboard that of the squares that show it
  SliceFusion fusion;
};

/// Pixels to draw over the slice of the first volume, row by row from the upper left. Outside the
/// volume they are transparent, and in a blend black is too, unless the colours are greys. The
/// squares of a checkerboard have sides of 20 mm and keep their place in the patient when the slice
/// is moved or zoomed.
/// @param image    the volume where it is placed
/// @param request  the slice, with the window and level of this volume
std::vector<Rgba> FusedPixels(
  vtkImageData* image, const SliceRequest& request, const FusedSlice& fused);

/// The colour of a part of the window, [0, 1].
std::array<std::uint8_t, 3> SliceColorOf(SliceColors colors, double part);

}

#endif
