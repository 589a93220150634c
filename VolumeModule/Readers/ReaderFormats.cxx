// The part of vtkVolumeFileReader that tells the formats and recognises files.
#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Formats.h"
#include "vtkVolumeFileReader.h"

namespace
{

bool IsFormat(int format)
{
  return 0 <= format && format < vtkVolumeFileReader::GetNumberOfFormats();
}

}

int vtkVolumeFileReader::GetNumberOfFormats()
{
  return int(varimarch::VolumeFormats().size());
}

const char* vtkVolumeFileReader::GetFormatName(int format)
{
  return IsFormat(format) ? varimarch::VolumeFormats()[format].name : nullptr;
}

const char* vtkVolumeFileReader::GetFormatDescription(int format)
{
  return IsFormat(format) ? varimarch::VolumeFormats()[format].description : nullptr;
}

std::string vtkVolumeFileReader::GetFormatExtensions(int format)
{
  std::string all;
  if (!IsFormat(format))
  {
    return all;
  }
  for (const std::string& extension : varimarch::VolumeFormats()[format].extensions)
  {
    all += (all.empty() ? "" : " ") + extension;
  }
  return all;
}

const char* vtkVolumeFileReader::GetFormatOfFile(const char* path)
{
  const varimarch::DecoderSession session;
  const auto* format = path ? varimarch::FormatIfReadable(path) : nullptr;
  return format ? format->name : nullptr;
}

bool vtkVolumeFileReader::CanReadFile(const char* path)
{
  const varimarch::DecoderSession session;
  return path && varimarch::LooksReadable(path);
}
