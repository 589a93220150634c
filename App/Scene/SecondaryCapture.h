#ifndef Varimarch_Scene_SecondaryCapture_h
#define Varimarch_Scene_SecondaryCapture_h

#include <vtkImageData.h>

#include <cstdint>
#include <map>
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

}

#endif
