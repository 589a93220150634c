#ifndef Varimarch_Scene_ImageFiles_h
#define Varimarch_Scene_ImageFiles_h

#include "Scene/Scene.h"
#include "Scene/SecondaryCapture.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>

namespace varimarch
{

/// Rendered images are vtkImageData with a single slice, the bottom row first. "Float" images hold
/// premultiplied RGBA, "byte" images RGB from 0 to 255.

enum class PictureFormat
{
  Png,
  Dicom, ///< a Secondary Capture Image, see SecondaryCapture.h
};

/// How an image was made.
struct PictureOrigin
{
  RenderOptions render;
  MapperKind mapper = MapperKind::Varimarch;
  std::string scene = {}; ///< the scene as text, for a PNG's entry "varimarch-scene"; may be empty
  CaptureIdentity identity = {}; ///< for a DICOM file; usually empty
  bool isPreview = false;        ///< true for the image of a coarse copy of a volume
};

/// Composites a float image over a background and rounds it to bytes.
vtkSmartPointer<vtkImageData> BytesOver(
  vtkImageData* floatPicture, const std::array<double, 3>& background);

/// A byte image encoded as PNG.
std::string PngBytes(vtkImageData* bytePicture);

/// Writes a byte image as PNG. @throws std::runtime_error that names the file
void WritePng(vtkImageData* bytePicture, const std::string& path);

/// The format for a file's extension, .png or .dcm; empty for others.
std::optional<PictureFormat> PictureFormatOf(const std::string& path);

/// Writes a byte image in the format of the path's extension. A PNG may have a fourth component,
/// opacity. An existing file is replaced when the new one is complete.
/// @throws std::runtime_error that names the file, also if its extension is of no format
void WritePicture(vtkImageData* bytePicture, const PictureOrigin& origin, const std::string& path);

}

#endif
