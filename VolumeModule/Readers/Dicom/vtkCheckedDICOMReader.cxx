#include "Readers/Dicom/vtkCheckedDICOMReader.h"

#include <vtkErrorCode.h>
#include <vtkObjectFactory.h>

#include <gdcmImageReader.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkCheckedDICOMReader);

bool vtkCheckedDICOMReader::ReadFileDelegated(
  const char* path, int, unsigned char* buffer, vtkIdType bufferSize)
{
  gdcm::ImageReader reader;
  reader.SetFileName(path);
  const bool isRead = reader.Read();
  const auto wanted = std::size_t(bufferSize);
  const std::size_t decoded = isRead ? reader.GetImage().GetBufferLength() : 0;
  bool isDecoded = false;
  if (isRead && decoded == wanted)
  {
    isDecoded = reader.GetImage().GetBuffer(reinterpret_cast<char*>(buffer));
  }
  else if (decoded > wanted)
  {
    std::vector<char> all(decoded);
    isDecoded = reader.GetImage().GetBuffer(all.data());
    std::copy_n(all.begin(), bufferSize, buffer);
  }
  if (!isDecoded)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
  }
  return isDecoded;
}
