#ifndef Varimarch_March_ImageOutput_h
#define Varimarch_March_ImageOutput_h

#include <vector>

class vtkImageData;

namespace varimarch
{

/// Makes premultiplied RGBA an image of VTK_UNSIGNED_CHAR, over white that is clear, as VTK's
/// mapper has it.
void FillColorImage(const std::vector<float>& rgba, int width, int height, vtkImageData* image);

/// Makes an image of depths, 0 at the near plane and 1 at the far one, or where nothing is;
/// integers have the range of their type.
/// @param rgba  1 - depth, as red
void FillDepthImage(
  const std::vector<float>& rgba, int width, int height, int scalarType, vtkImageData* image);

}

#endif
