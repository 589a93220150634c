#ifndef Varimarch_Scene_ImageFiles_h
#define Varimarch_Scene_ImageFiles_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace varimarch
{

/// Rendered images are vtkImageData with a single slice, the bottom row first. "Float" images hold
/// premultiplied RGBA, "byte" images RGB from 0 to 255.

/// Composites a float image over a background and rounds it to bytes.
vtkSmartPointer<vtkImageData> BytesOver(
  vtkImageData* floatPicture, const std::array<double, 3>& background);

/// A byte image encoded as PNG.
std::string PngBytes(vtkImageData* bytePicture);

/// Writes a byte image as PNG. @throws std::runtime_error that names the file
void WritePng(vtkImageData* bytePicture, const std::string& path);

}

#endif
