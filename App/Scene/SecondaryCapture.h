#ifndef Varimarch_Scene_SecondaryCapture_h
#define Varimarch_Scene_SecondaryCapture_h

#include <vtkImageData.h>

#include <string>

namespace varimarch
{

/// Writes a byte image of RGB as a DICOM Secondary Capture Image (PS3.3 A.8.1), uncompressed, in
/// explicit little endian. The image begins a study of its own. The file holds nothing of the scan
/// or the patient: the patient's attributes that the standard requires are empty.
/// @param derivation  how the image was made, in ASCII, at most 1024 characters
/// @returns false if the system refuses to write; errno then has its reason
bool WriteSecondaryCapture(
  vtkImageData* bytePicture, const std::string& derivation, const std::string& path);

}

#endif
