#ifndef Varimarch_March_ImageOutput_h
#define Varimarch_March_ImageOutput_h

#include <vector>

class vtkImageData;

namespace varimarch
{

/// Fills an image of VTK_UNSIGNED_CHAR from premultiplied RGBA, over transparent white, as VTK's
/// mapper does.
void FillColorImage(const std::vector<float>& rgba, int width, int height, vtkImageData* image);

/// Fills an image of depths: 0 at the near plane, 1 at the far plane and on rays without a depth.
/// Integers span the range of their type.
/// @param rgba  1 - depth in the red channel
void FillDepthImage(
  const std::vector<float>& rgba, int width, int height, int scalarType, vtkImageData* image);

}

#endif
