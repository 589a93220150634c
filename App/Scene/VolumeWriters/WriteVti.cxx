// VTK's XML image data, by VTK's own writer.
#include "Scene/VolumeWriters/VolumeWriters.h"
#include "Scene/VolumeWriters/WrittenImage.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

namespace varimarch
{

bool WriteVtiFile(const LoadedVolume& volume, const std::string& path, bool)
{
  const WrittenImage checked(path, volume.image);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(volume.image);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  // Arrays beyond 4 GB need headers of 64 bits.
  writer->SetHeaderTypeToUInt64();
  return writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
}

}
