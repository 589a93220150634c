#include "Readers/Dicom/DicomSeries.h"

#include "Readers/Decoder/DicomDecoding.h"
#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/FileSearch.h"
#include "Readers/FileError.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace varimarch
{
namespace
{

/// Finds files that are copies of others. Files of one image have one UID; but programs that remove
/// names have given one to all images of a series, so that files with the same UID are copies only
/// if they have the same places, numbers and pixels.
class Copies
{
public:
  /// True if a file is a copy of an earlier one; otherwise it becomes known.
  /// @param frames  the frames of the file, at least one
  bool IsCopy(const std::vector<DicomFrame>& frames);

  /// Number of files that share the UID of an earlier file and are no copies.
  std::size_t SharedUids() const { return this->sharedUids; }

private:
  std::size_t DigestOf(const DicomFile& file);

  /// The first frames of the files of each image, by the UIDs of its series and its own.
  std::map<std::pair<std::string, std::string>, std::vector<DicomFrame>> known;
  /// Digests of the files whose UID occurred again, by path.
  std::map<std::string, std::size_t> digests;
  std::size_t sharedUids = 0;
};

bool HaveSameAttributes(const DicomFrame& a, const DicomFrame& b)
{
  return a.size == b.size && a.file->frameCount == b.file->frameCount &&
    a.positionMm == b.positionMm && a.axes == b.axes && a.heightMm == b.heightMm &&
    a.instanceNumber == b.instanceNumber && a.differences == b.differences && a.slope == b.slope &&
    a.intercept == b.intercept;
}

bool Copies::IsCopy(const std::vector<DicomFrame>& frames)
{
  const DicomFrame& first = frames.front();
  const DicomFile& file = *first.file;
  if (file.instanceUid.empty())
  {
    return false;
  }
  std::vector<DicomFrame>& others = this->known[{ file.seriesUid, file.instanceUid }];
  const bool isCopy = std::any_of(others.begin(), others.end(),
    [&](const DicomFrame& other)
    {
      return HaveSameAttributes(first, other) &&
        this->DigestOf(file) == this->DigestOf(*other.file);
    });
  if (!isCopy)
  {
    this->sharedUids += others.empty() ? 0 : 1;
    others.push_back(first);
  }
  return isCopy;
}

/// A digest of the end of a file, which are its pixels; of its second half if they are compressed.
std::size_t Copies::DigestOf(const DicomFile& file)
{
  const auto known = this->digests.find(file.path);
  if (known != this->digests.end())
  {
    return known->second;
  }
  std::error_code ignored;
  const double fileBytes = double(std::filesystem::file_size(file.path, ignored));
  const double pixelBytes =
    IsUncompressed(file) ? StoredBytes(file, file.frameCount) : fileBytes / 2;
  std::string bytes(ignored ? 0 : std::size_t(std::min(pixelBytes, fileBytes)), '\0');
  std::ifstream stream(file.path, std::ios::binary);
  stream.seekg(-std::streamoff(bytes.size()), std::ios::end);
  stream.read(bytes.data(), std::streamsize(bytes.size()));
  return this->digests[file.path] = std::hash<std::string>()(bytes);
}

bool IsSingleSlice(const DicomSeries& series)
{
  const DicomFrame& first = series.frames.front();
  return series.frames.size() == 1 && !first.file->isSegmentation && first.positionMm &&
    first.axes && first.pixelMm && !first.file->frameOfReference.empty();
}

bool MayBeOneVolume(const DicomSeries& a, const DicomSeries& b)
{
  constexpr double LargestDifference = 1e-3;
  const DicomFrame& first = a.frames.front();
  const DicomFrame& second = b.frames.front();
  return a.number == b.number && a.modality == b.modality && a.description == b.description &&
    first.file->frameOfReference == second.file->frameOfReference && first.size == second.size &&
    glm::distance(*first.pixelMm, *second.pixelMm) < LargestDifference &&
    glm::distance((*first.axes)[0], (*second.axes)[0]) < LargestDifference &&
    glm::distance((*first.axes)[1], (*second.axes)[1]) < LargestDifference;
}

bool LieAtOnePlace(const DicomSeries* a, const DicomSeries* b)
{
  constexpr double SamePlaceMm = 1e-3;
  return glm::distance(*a->frames.front().positionMm, *b->frames.front().positionMm) < SamePlaceMm;
}

/// True if no two series of a group lie at one place.
bool LieApart(const std::vector<DicomSeries*>& group)
{
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (LieAtOnePlace(group[i], group[j]))
      {
        return false;
      }
    }
  }
  return true;
}

/// Joins series of a single image each that are the slices of one volume, as some programs write
/// them: they have one number, modality, description, space, size, pixel size and direction, and
/// lie at different places.
/// @param warnings  receives a sentence about those that were joined
void JoinSingleImages(std::vector<DicomSeries>& all, std::vector<std::string>& warnings)
{
  constexpr std::size_t LeastCount = 3; // fewer may be anything
  std::vector<std::vector<DicomSeries*>> groups;
  for (DicomSeries& series : all)
  {
    if (IsSingleSlice(series))
    {
      const auto known = std::find_if(groups.begin(), groups.end(),
        [&](const auto& group) { return MayBeOneVolume(*group.front(), series); });
      known == groups.end() ? groups.push_back({ &series }) : known->push_back(&series);
    }
  }
  for (const std::vector<DicomSeries*>& group : groups)
  {
    if (group.size() < LeastCount || !LieApart(group))
    {
      continue;
    }
    for (auto series = group.begin() + 1; series != group.end(); ++series)
    {
      group.front()->frames.push_back((*series)->frames.front());
      (*series)->frames.clear();
    }
    warnings.push_back(std::to_string(group.size()) +
      " series of one image each were joined, since they have the same number, size and direction "
      "and lie beside each other: " +
      FrameList(group.front()->frames) + ".");
  }
  all.erase(std::remove_if(all.begin(), all.end(),
              [](const DicomSeries& series) { return series.frames.empty(); }),
    all.end());
}

/// The series of the scan that a file belongs to; a new one if it is the first file.
DicomSeries& SeriesOf(const DicomFile& file, std::vector<DicomSeries>& all)
{
  const auto isSame = [&](const DicomSeries& series)
  { return series.uid == file.seriesUid && series.modality == file.modality; };
  const auto known = std::find_if(all.begin(), all.end(), isSame);
  if (known != all.end())
  {
    return *known;
  }
  all.push_back({ file.seriesUid, file.seriesDescription, file.modality, file.seriesNumber, {} });
  return all.back();
}

/// A collection of series from files, one after the other.
class Collection
{
public:
  explicit Collection(DicomScan& scan)
    : scan(scan)
  {
  }

  void Add(const std::string& path, const DicomContent& content)
  {
    this->hasOther |= content.isDicom && !content.file && !content.fault;
    if (content.fault)
    {
      this->scan.faults.push_back(*content.fault);
    }
    if (content.frames.empty())
    {
      return;
    }
    const DicomFile& file = *content.file;
    if (this->copies.IsCopy(content.frames))
    {
      this->repeated.push_back(Quoted(std::filesystem::path(path).filename().string()));
      return;
    }
    DicomSeries& series = SeriesOf(file, this->scan.series);
    series.frames.insert(series.frames.end(), content.frames.begin(), content.frames.end());
  }

  /// @throws std::runtime_error if there is no series
  void Finish(const std::string& path)
  {
    if (this->scan.series.empty())
    {
      if (!this->scan.faults.empty())
      {
        const DicomFault& fault = this->scan.faults.front();
        FailToRead(fault.path, fault.expected, fault.found);
      }
      FailToRead(
        path, "DICOM images", this->hasOther ? "DICOM files without pixels" : "no DICOM file");
    }
    if (!this->repeated.empty())
    {
      this->scan.warnings.push_back("Images were left out because they are copies of others: " +
        NameList(this->repeated) + ".");
    }
    if (this->copies.SharedUids() > 0)
    {
      this->scan.warnings.push_back(std::to_string(this->copies.SharedUids()) +
        " images have the identifier of another image, but other content; all were read.");
    }
    JoinSingleImages(this->scan.series, this->scan.warnings);
    for (DicomSeries& series : this->scan.series)
    {
      std::stable_sort(series.frames.begin(), series.frames.end(),
        [](const DicomFrame& a, const DicomFrame& b)
        { return a.instanceNumber < b.instanceNumber; });
    }
    std::stable_sort(this->scan.series.begin(), this->scan.series.end(),
      [](const DicomSeries& a, const DicomSeries& b)
      {
        return std::make_tuple(IsSegmentation(a), -double(a.frames.size()), a.number) <
          std::make_tuple(IsSegmentation(b), -double(b.frames.size()), b.number);
      });
  }

private:
  DicomScan& scan;
  Copies copies;
  std::vector<std::string> repeated;
  bool hasOther = false; ///< true if there are DICOM files without pixels
};

}

bool IsSegmentation(const DicomSeries& series)
{
  return series.frames.front().file->isSegmentation;
}

DicomScan FindDicomSeries(const std::string& path, ReadProgress& progress)
{
  DicomScan scan;
  ReadProgress searching = progress.Part(0.0, 0.1);
  ReadProgress reading = progress.Part(0.1, 1.0);
  const std::vector<std::string> files = FindDicomFiles(path, scan.warnings, searching);
  Collection collection(scan);
  ForEachContent(
    files, [&](std::size_t i, const DicomContent& content) { collection.Add(files[i], content); },
    reading);
  collection.Finish(path);
  return scan;
}

const DicomSeries& SeriesNamed(
  const std::string& path, const std::vector<DicomSeries>& all, const std::string& name)
{
  if (name.empty())
  {
    return all.front();
  }
  std::vector<const DicomSeries*> named;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].uid == name || name == std::to_string(i + 1))
    {
      return all[i];
    }
    if (all[i].uid.compare(0, name.size(), name) == 0)
    {
      named.push_back(&all[i]);
    }
  }
  if (named.size() != 1)
  {
    FailToRead(path,
      (named.empty() ? "the series " : "just one series whose UID begins with ") + Quoted(name),
      SeriesList(all));
  }
  return *named.front();
}

std::string SeriesList(const std::vector<DicomSeries>& all)
{
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const DicomSeries& series = all[i];
    list += (i > 0 ? ", " : "") + std::to_string(i + 1) + " (" + series.modality + ", " +
      std::to_string(series.frames.size()) + " images, " +
      (series.description.empty() ? "" : series.description + ", ") + series.uid + ")";
  }
  // Descriptions were typed by people, and the list may be printed to a terminal.
  std::replace_if(
    list.begin(), list.end(), [](unsigned char letter) { return letter < ' '; }, '?');
  return list;
}

}
