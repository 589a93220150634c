#ifndef Varimarch_Scene_ImageFiles_h
#define Varimarch_Scene_ImageFiles_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace varimarch
{

/// Pictures here are vtkImageData with one slice, row 0 at the bottom: "float" ones are
/// premultiplied RGBA, "byte" ones RGB from 0 to 255.

/// A float picture in front of a background, rounded to bytes.
vtkSmartPointer<vtkImageData> BytesOver(
  vtkImageData* floatPicture, const std::array<double, 3>& background);

/// A byte picture as the bytes of a PNG file.
std::string PngBytes(vtkImageData* bytePicture);

/// Writes a byte picture as PNG. @throws std::runtime_error that names the file
void WritePng(vtkImageData* bytePicture, const std::string& path);

}

#endif
