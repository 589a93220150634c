#include "Readers/DicomSeries.h"

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

namespace varimarch
{
namespace
{

/// Sets a scan up, not yet done: of a folder, or of one file.
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
  // Patient, study and series may each have a folder.
  directory->SetScanDepth(4);
  // What to collect of each file, beside what vtk-dicom always does. Empty values match anything.
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

/// Fails for a file that promises more pixels than it can hold, because vtk-dicom would make room
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
  // Blank images have been seen to shrink a thousandfold, hardly more.
  if (promisedBytes > fileBytes * (isPlain ? 1.0 : 20000.0))
  {
    FailToRead(path, std::to_string(std::int64_t(promisedBytes)) + " bytes of pixels",
      "a file of " + std::to_string(std::int64_t(fileBytes)));
  }
}

DicomSeries SeriesOf(vtkDICOMDirectory* directory, int index)
{
  const vtkDICOMItem& record = directory->GetSeriesRecord(index);
  vtkDICOMMetaData* meta = directory->GetMetaDataForSeries(index);
  DicomSeries series = { record.Get(DC::SeriesInstanceUID).AsString(),
    record.Get(DC::SeriesDescription).AsUTF8String(), record.Get(DC::Modality).AsString(), 0,
    directory->GetFileNamesForSeries(index) };
  for (int file = 0; file < int(series.files->GetNumberOfValues()); ++file)
  {
    CheckFileHolds(series.files->GetValue(file), meta, file);
    series.imageCount += FrameCount(meta, file);
  }
  return series;
}

/// What there is when there are no images.
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
  for (int index = 0; index < directory->GetNumberOfSeries(); ++index)
  {
    all.push_back(SeriesOf(directory, index));
  }
  for (const auto* list : { &messages.Errors(), &messages.Warnings() })
  {
    warnings.insert(warnings.end(), list->begin(), list->end());
  }
  return all;
}

}
