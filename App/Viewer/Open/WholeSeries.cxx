#include "Viewer/Open/WholeSeries.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/Record.h"

#include <vtkVolumeFileReader.h>

#include <filesystem>
#include <set>
#include <vector>

namespace varimarch
{

namespace
{

// Reads a file that nothing else is known of.
DicomRecord RecordOfFile(const std::string& path, ReadProgress& progress)
{
  DicomRecord found;
  ForEachRecord(
    { path }, [&](std::size_t, const DicomRecord& record) { found = record; }, progress);
  return found;
}

}

std::optional<WholeSeries> WholeSeriesOf(const std::string& path, const TaskProgress& goesOn)
{
  const char* const format = vtkVolumeFileReader::GetFormatOfFile(path.c_str());
  if (!format || format != std::string("DICOM") || !std::filesystem::is_regular_file(path))
  {
    return std::nullopt;
  }
  const DecoderSession session;
  ReadProgress progress(goesOn);
  const std::string uid = RecordOfFile(path, progress).seriesUid;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path().string());
    }
  }
  std::set<std::string> images; // a copy of an image is the same one
  ForEachRecord(
    files,
    [&](std::size_t, const DicomRecord& record)
    {
      if (!uid.empty() && record.seriesUid == uid)
      {
        images.insert(record.imageUid);
      }
    },
    progress);
  return images.size() > 1 ? std::optional(WholeSeries{ folder, uid, int(images.size()) })
                           : std::nullopt;
}

}
