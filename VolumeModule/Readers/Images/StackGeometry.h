#ifndef Varimarch_Readers_Images_StackGeometry_h
#define Varimarch_Readers_Images_StackGeometry_h

#include "Readers/ImageGeometry.h"

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// Geometry of a stack of pictures: x runs to the right of the first, y down, z through the stack.
/// Adds warnings about what the files do not say.
/// @param spacingMm  distances of voxels along x, y and z; 0 if unknown
/// @param orientation  TIFF's tag Orientation, 1 to 8: where the first row and column are
ImageGeometry StackGeometry(
  const std::array<double, 3>& spacingMm, int orientation, std::vector<std::string>& warnings);

}

#endif
