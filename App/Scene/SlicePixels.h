#ifndef Varimarch_Scene_SlicePixels_h
#define Varimarch_Scene_SlicePixels_h

#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Grey pixels, row by row from the upper left.
struct GrayPicture
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The middle slice of a volume in storage order, rows downwards. The 1st percentile is black, the
/// 99th white.
GrayPicture MiddleSlice(vtkImageData* image);

}

#endif
