#ifndef Varimarch_Scene_SlicePixels_h
#define Varimarch_Scene_SlicePixels_h

#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Gray pixels, row by row from the upper left.
struct GrayPicture
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The slice in the middle of a volume as it is stored, rows downwards; from its 1st percentile,
/// black, to its 99th, white.
GrayPicture MiddleSlice(vtkImageData* image);

}

#endif
