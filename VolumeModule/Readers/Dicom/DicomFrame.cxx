#include "Readers/Dicom/DicomFrame.h"

#include "Readers/FileError.h"

#include <algorithm>
#include <filesystem>

namespace varimarch
{

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
