#ifndef Varimarch_Scene_SliceFusing_h
#define Varimarch_Scene_SliceFusing_h

#include "Scene/SlicePicture.h"
#include "Scene/SliceSegments.h"

#include <vector>

class vtkImageData;

namespace varimarch
{

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
