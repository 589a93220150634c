#ifndef Varimarch_Scene_ImageFiles_h
#define Varimarch_Scene_ImageFiles_h

#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace varimarch
{

/// Attributes of an image of a patient by their tags, such as 0x00100010 for the patient's name.
/// Texts are in UTF-8.
using CaptureIdentity = std::map<std::uint32_t, std::string>;

/// Writes a byte image of RGB as a DICOM Secondary Capture Image (PS3.3 A.8.1), uncompressed, in
/// explicit little endian. Without an identity the image begins a study of its own, and the file
/// holds nothing of the scan or the patient: the patient's attributes that the standard requires
/// are empty. With one it belongs to that patient and that study.
/// @param derivation  how the image was made, in ASCII, at most 1024 characters
/// @param identity  only the attributes of the patient and the study are copied
/// @returns false if the system refuses to write; errno then has its reason
bool WriteSecondaryCapture(vtkImageData* bytePicture, const std::string& derivation,
  const std::string& path, const CaptureIdentity& identity = {});

/// Rendered images are vtkImageData with a single slice, the bottom row first. "Float" images hold
/// premultiplied RGBA, "byte" images RGB from 0 to 255.

enum class PictureFormat
{
  Png,
  Dicom, ///< a Secondary Capture Image, see WriteSecondaryCapture
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
