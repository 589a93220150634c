#include "Readers/Dicom/DicomFrame.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
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

namespace
{

/// The whole number at a place of a text; 0 if there is none.
int NumberAt(const std::string& text, std::size_t from, std::size_t count)
{
  return from < text.size() ? std::atoi(text.substr(from, count).c_str()) : 0;
}

}

std::optional<double> SecondsOfMoment(const std::string& date, const std::string& time)
{
  const std::string clock = time.substr(0, time.find_first_not_of("0123456789."));
  if (date.size() < 8 || clock.size() < 2)
  {
    return std::nullopt;
  }
  std::tm moment = {};
  moment.tm_year = NumberAt(date, 0, 4) - 1900;
  moment.tm_mon = NumberAt(date, 4, 2) - 1;
  moment.tm_mday = NumberAt(date, 6, 2);
  moment.tm_hour = NumberAt(clock, 0, 2);
  moment.tm_min = NumberAt(clock, 2, 2);
  const double seconds = clock.size() > 4 ? NumberIn(clock.substr(4)).value_or(0.0) : 0.0;
  return double(timegm(&moment)) + seconds;
}

std::optional<double> SecondsOfZone(const std::string& text)
{
  constexpr std::size_t Letters = 5;
  constexpr double SecondsPerMinute = 60.0;
  const std::string zone = text.size() < Letters ? "" : text.substr(text.size() - Letters);
  if (zone.empty() || zone.find_first_not_of("0123456789", 1) != std::string::npos ||
    (zone[0] != '+' && zone[0] != '-'))
  {
    return std::nullopt;
  }
  const double minutes = 60.0 * NumberAt(zone, 1, 2) + NumberAt(zone, 3, 2);
  return (zone[0] == '-' ? -1.0 : 1.0) * SecondsPerMinute * minutes;
}

}
