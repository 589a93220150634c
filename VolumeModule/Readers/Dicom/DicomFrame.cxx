#include "Readers/Dicom/DicomFrame.h"

#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace varimarch
{

bool IsUncompressed(const DicomFile& file)
{
  const std::string& syntax = file.transferSyntax;
  return syntax.empty() || syntax == "1.2.840.10008.1.2" || syntax == "1.2.840.10008.1.2.1" ||
    syntax == "1.2.840.10008.1.2.2" || syntax == "1.2.840.10008.1.20" ||
    syntax == "1.2.840.113619.5.2";
}

double StoredBytes(const DicomFile& file, int frameCount)
{
  // Two pixels of "422" share two of their three values.
  const bool isHalved = file.colours.find("_422") != std::string::npos;
  const double values = double(file.rows) * file.columns * (isHalved ? 2 : file.samples);
  return std::floor((values * file.bitsAllocated * frameCount + 7.0) / 8.0);
}

void CheckFrames(const std::string& path, const DicomFile& file)
{
  const int type = file.bitsAllocated <= 8 ? VTK_UNSIGNED_CHAR
    : file.bitsAllocated <= 16             ? VTK_SHORT
                                           : VTK_DOUBLE;
  CheckedByteCount(path, { { file.columns, file.rows, file.frameCount }, type, file.samples });
}

std::string FrameName(const DicomFrame& frame)
{
  const std::string name = Quoted(std::filesystem::path(frame.file->path).filename().string());
  return frame.file->frameCount == 1 ? name
                                     : "frame " + std::to_string(frame.number + 1) + " of " + name;
}

std::string NameList(const std::vector<std::string>& names)
{
  constexpr std::size_t MostNamed = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), MostNamed); ++i)
  {
    text += (i > 0 ? ", " : "") + names[i];
  }
  const std::size_t others = names.size() - std::min(names.size(), MostNamed);
  return others == 0
    ? text
    : text + " and " + std::to_string(others) + (others == 1 ? " other" : " others");
}

std::string FrameList(const std::vector<DicomFrame>& frames)
{
  std::vector<std::string> names;
  names.reserve(frames.size());
  std::transform(frames.begin(), frames.end(), std::back_inserter(names), FrameName);
  // The tiles of a mosaic share a name.
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return NameList(names);
}

}
