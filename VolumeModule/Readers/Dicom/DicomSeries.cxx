#include "Readers/Dicom/DicomSeries.h"

#include "Readers/Decoder/DicomDecoding.h"
#include "Readers/Dicom/Copies.h"
#include "Readers/Dicom/FileSearch.h"
#include "Readers/Dicom/JoinedSeries.h"
#include "Readers/FileError.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace varimarch
{
namespace
{

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
