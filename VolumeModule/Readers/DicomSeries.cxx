#include "Readers/DicomSeries.h"

#include "Readers/DicomSlices.h"
#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/VtkMessages.h"
#include "Readers/VtkProgress.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMDirectory.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace varimarch
{
namespace
{

/// Prepares a scan of a folder or of one file, without running it.
void Prepare(vtkDICOMDirectory* directory, const std::string& path)
{
  const std::filesystem::path place = path;
  const bool isIndex = LowerCase(place.filename().string()) == "dicomdir";
  if (std::filesystem::is_directory(place) || isIndex)
  {
    const std::filesystem::path folder = isIndex ? place.parent_path() : place;
    directory->SetDirectoryName(folder.empty() ? "." : folder.c_str());
  }
  else
  {
    vtkNew<vtkStringArray> files;
    files->InsertNextValue(path);
    directory->SetInputFileNames(files);
  }
  // Allows one folder each for patient, study and series.
  directory->SetScanDepth(4);
  // Attributes to collect for each file in addition to those that vtk-dicom always collects. Empty
  // values match anything.
  vtkDICOMItem query;
  for (const vtkDICOMTag tag : { vtkDICOMTag(DC::TransferSyntaxUID), vtkDICOMTag(DC::Rows),
         vtkDICOMTag(DC::Columns), vtkDICOMTag(DC::NumberOfFrames), vtkDICOMTag(DC::BitsAllocated),
         vtkDICOMTag(DC::SamplesPerPixel), vtkDICOMTag(DC::SeriesDescription) })
  {
    query.Set(tag, vtkDICOMValue());
  }
  directory->SetFindQuery(query);
}

std::int64_t FrameCount(vtkDICOMMetaData* meta, int file)
{
  return std::max<std::int64_t>(1, meta->Get(file, DC::NumberOfFrames).AsInt());
}

/// Fails if a file promises more pixels than it can hold, because vtk-dicom would allocate memory
/// for each of its frames.
void CheckFileHolds(const std::string& path, vtkDICOMMetaData* meta, int file)
{
  const std::string syntax = meta->Get(file, DC::TransferSyntaxUID).AsString();
  const bool isPlain = syntax.empty() || syntax == "1.2.840.10008.1.2" ||
    syntax == "1.2.840.10008.1.2.1" || syntax == "1.2.840.10008.1.2.2";
  const double samples = std::max(1.0, meta->Get(file, DC::SamplesPerPixel).AsDouble());
  const double imageBytes = meta->Get(file, DC::Rows).AsDouble() *
    meta->Get(file, DC::Columns).AsDouble() * meta->Get(file, DC::BitsAllocated).AsDouble() / 8.0;
  const double promisedBytes = imageBytes * double(FrameCount(meta, file)) *
    (meta->Get(file, DC::PhotometricInterpretation).AsString() == "YBR_FULL_422" ? 2.0 : samples);
  const double fileBytes = double(ReadableFileSize(path));
  // Blank images may shrink about a thousandfold, hardly more.
  if (promisedBytes > fileBytes * (isPlain ? 1.0 : 20000.0))
  {
    FailToRead(path, std::to_string(std::int64_t(promisedBytes)) + " bytes of pixels",
      "a file of " + std::to_string(std::int64_t(fileBytes)));
  }
}

/// Keeps the files whose images have the most frequent size. Others, such as a scout view, are not
/// slices of the same volume.
void TakeImagesOfOneSize(vtkStringArray* files, vtkDICOMMetaData* meta, DicomSeries& series,
  std::vector<std::string>& leftOut)
{
  using Size = std::pair<int, int>;
  const auto sizeOf = [&](int file)
  { return Size(meta->Get(file, DC::Rows).AsInt(), meta->Get(file, DC::Columns).AsInt()); };
  std::map<Size, std::int64_t> counts;
  for (int file = 0; file < int(files->GetNumberOfValues()); ++file)
  {
    counts[sizeOf(file)] += FrameCount(meta, file);
  }
  const auto most = std::max_element(
    counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });

  series.files = vtkSmartPointer<vtkStringArray>::New();
  for (int file = 0; file < int(files->GetNumberOfValues()); ++file)
  {
    if (sizeOf(file) == most->first)
    {
      CheckFileHolds(files->GetValue(file), meta, file);
      series.files->InsertNextValue(files->GetValue(file));
      series.imageCount += FrameCount(meta, file);
    }
    else
    {
      leftOut.push_back(FileName(files->GetValue(file)));
    }
  }
}

DicomSeries SeriesOf(vtkDICOMDirectory* directory, int index, std::vector<std::string>& warnings)
{
  const vtkDICOMItem& record = directory->GetSeriesRecord(index);
  DicomSeries series = { record.Get(DC::SeriesInstanceUID).AsString(),
    record.Get(DC::SeriesDescription).AsUTF8String(), record.Get(DC::Modality).AsString(), 0,
    nullptr };
  std::vector<std::string> leftOut;
  TakeImagesOfOneSize(directory->GetFileNamesForSeries(index),
    directory->GetMetaDataForSeries(index), series, leftOut);
  if (!leftOut.empty())
  {
    warnings.push_back("Images were left out because their size differs from that of the others: " +
      FileList(leftOut) + ".");
  }
  return series;
}

/// Describes a path that holds no images, for an error message.
std::string WithoutImages(const std::string& path)
{
  VtkMessages messages;
  vtkNew<vtkDICOMDirectory> directory;
  messages.Take(directory);
  Prepare(directory, path);
  directory->RequirePixelDataOff();
  directory->Update();
  if (directory->GetNumberOfSeries() > 0)
  {
    return "DICOM files without pixels";
  }
  return messages.FirstErrorOr("no DICOM file");
}

}

std::vector<DicomSeries> FindDicomSeries(
  const std::string& path, std::vector<std::string>& warnings, ReadProgress& progress)
{
  VtkMessages messages;
  vtkNew<vtkDICOMDirectory> directory;
  messages.Take(directory);
  Prepare(directory, path);
  UpdateWithProgress(directory, progress);
  if (directory->GetNumberOfSeries() == 0)
  {
    FailToRead(path, "DICOM images", WithoutImages(path));
  }
  std::vector<DicomSeries> all;
  all.reserve(std::size_t(directory->GetNumberOfSeries()));
  for (int index = 0; index < directory->GetNumberOfSeries(); ++index)
  {
    all.push_back(SeriesOf(directory, index, warnings));
  }
  for (const auto* list : { &messages.Errors(), &messages.Warnings() })
  {
    warnings.insert(warnings.end(), list->begin(), list->end());
  }
  std::stable_sort(all.begin(), all.end(),
    [](const DicomSeries& a, const DicomSeries& b) { return a.imageCount > b.imageCount; });
  return all;
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
      std::to_string(series.imageCount) + " images, " +
      (series.description.empty() ? "" : series.description + ", ") + series.uid + ")";
  }
  // Descriptions were typed by people, and the list may be printed to a terminal.
  std::replace_if(
    list.begin(), list.end(), [](unsigned char letter) { return letter < ' '; }, '?');
  return list;
}

}
