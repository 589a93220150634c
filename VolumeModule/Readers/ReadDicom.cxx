// DICOM by means of vtk-dicom, which sorts slices and reads compressed and multi-frame files.
#include "Readers/DicomSeries.h"
#include "Readers/DicomSlices.h"
#include "Readers/DicomStack.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Rescale.h"
#include "Readers/VoxelLayout.h"
#include "Readers/VtkMessages.h"
#include "Readers/VtkProgress.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMReader.h>
#include <vtkDICOMSliceSorter.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace varimarch
{
namespace
{

/// Scope guard that silences std::cerr. GDCM, which decodes compressed slices for vtk-dicom, prints
/// there what vtk-dicom reports as an error anyway.
class SilentErrorStream
{
public:
  SilentErrorStream()
    : printed(std::cerr.rdbuf(this->ignored.rdbuf()))
  {
  }
  ~SilentErrorStream() { std::cerr.rdbuf(this->printed); }
  SilentErrorStream(const SilentErrorStream&) = delete;
  void operator=(const SilentErrorStream&) = delete;

private:
  std::ostringstream ignored;
  std::streambuf* printed;
};

/// Reads the slices in the order that UpdateInformation has determined.
void ReadSlices(const std::string& path, vtkDICOMReader* reader, const VtkMessages& messages,
  ReadProgress& progress)
{
  {
    const SilentErrorStream silent;
    UpdateWithProgress(reader, progress);
  }
  if (!messages.Errors().empty())
  {
    FailToRead(path, "complete DICOM images", messages.FirstErrorOr("incomplete ones"));
  }
}

/// Reads the headers of the files and sorts them.
void UpdateInformation(const std::string& path, vtkDICOMReader* reader, const VtkMessages& messages)
{
  reader->UpdateInformation();
  if (!messages.Errors().empty())
  {
    FailToRead(
      path, "a series of DICOM images of one kind", messages.FirstErrorOr("different kinds"));
  }
}

/// A stack of slices, as far as their order is known.
struct Stack
{
  std::string id;
  std::vector<std::string> fileNames;
};

std::vector<Stack> StacksOf(
  const std::string& path, vtkDICOMReader* reader, const VtkMessages& messages)
{
  std::vector<Stack> stacks;
  for (vtkIdType i = 0; i < reader->GetStackIDs()->GetNumberOfValues(); ++i)
  {
    stacks.push_back({ reader->GetStackIDs()->GetValue(i), {} });
  }
  for (Stack& stack : stacks)
  {
    reader->SetDesiredStackID(stack.id.c_str());
    UpdateInformation(path, reader, messages);
    for (int slice = 0; slice < SliceCount(reader); ++slice)
    {
      stack.fileNames.push_back(SliceFileName(reader, slice));
    }
  }
  return stacks;
}

/// Chooses the largest stack and the first time point of a series that has several.
void ChooseStackAndTime(const std::string& path, vtkDICOMReader* reader,
  const VtkMessages& messages, std::vector<std::string>& warnings)
{
  UpdateInformation(path, reader, messages);
  KeepOneDirection(reader, warnings);
  UpdateInformation(path, reader, messages);
  if (reader->GetStackIDs()->GetNumberOfValues() > 1)
  {
    std::vector<Stack> stacks = StacksOf(path, reader, messages);
    const auto largest = std::max_element(stacks.begin(), stacks.end(),
      [](const Stack& a, const Stack& b) { return a.fileNames.size() < b.fileNames.size(); });
    std::iter_swap(stacks.begin(), largest);
    reader->SetDesiredStackID(stacks.front().id.c_str());
    std::vector<std::string> leftOut;
    for (auto stack = stacks.begin() + 1; stack != stacks.end(); ++stack)
    {
      leftOut.insert(leftOut.end(), stack->fileNames.begin(), stack->fileNames.end());
    }
    warnings.push_back("The series has " + std::to_string(stacks.size()) +
      " stacks of slices; only the largest was read, without " + FileList(leftOut) + ".");
  }
  if (reader->GetTimeDimension() > 1)
  {
    warnings.push_back(OnlyFirstVolume(reader->GetTimeDimension()));
    reader->SetDesiredTimeIndex(0);
  }
  UpdateInformation(path, reader, messages);
}

VoxelLayout LayoutOf(vtkDICOMReader* reader)
{
  vtkInformation* output = reader->GetOutputInformation(0);
  const int* extent = output->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  return { { extent[1] + 1, extent[3] + 1, extent[5] + 1 }, reader->GetDataScalarType(),
    reader->GetNumberOfScalarComponents() };
}

/// The patient matrix maps mm along the image's axes to LPS; a tilted gantry shears it.
ImageGeometry GeometryOf(vtkDICOMReader* reader)
{
  vtkMatrix4x4* matrix = reader->GetPatientMatrix();
  ImageGeometry geometry;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.axesMm[axis][row] = matrix->GetElement(row, axis) * reader->GetDataSpacing()[axis];
    }
    geometry.originMm[row] = matrix->GetElement(row, 3);
  }
  return geometry;
}

std::vector<Rescale> RescaleOf(vtkDICOMReader* reader)
{
  std::vector<Rescale> slices;
  for (int slice = 0; slice < SliceCount(reader); ++slice)
  {
    const vtkDICOMValue& slope = SliceValue(reader, slice, DC::RescaleSlope);
    const vtkDICOMValue& intercept = SliceValue(reader, slice, DC::RescaleIntercept);
    Rescale rescale;
    if (slope.IsValid() && intercept.IsValid() && slope.AsDouble() != 0.0)
    {
      rescale = { slope.AsDouble(), intercept.AsDouble() };
    }
    slices.push_back(rescale);
  }
  return slices;
}

/// Determines the weighting from the sequence's times; empty for times in between.
std::string WeightingOf(vtkDICOMReader* reader)
{
  constexpr double ShortestEchoMsOfT2 = 60.0;
  constexpr double LongestEchoMsOfT1 = 30.0;
  constexpr double LongestRepetitionMsOfT1 = 1000.0;
  if (SliceValue(reader, 0, DC::AngioFlag).AsString() == "Y")
  {
    return "angiography";
  }
  const double echoMs = SliceValue(reader, 0, DC::EchoTime).AsDouble();
  const double repetitionMs = SliceValue(reader, 0, DC::RepetitionTime).AsDouble();
  if (echoMs >= ShortestEchoMsOfT2)
  {
    return "T2";
  }
  const bool isShort = echoMs <= LongestEchoMsOfT1 && repetitionMs <= LongestRepetitionMsOfT1;
  return echoMs > 0.0 && repetitionMs > 0.0 && isShort ? "T1" : "";
}

/// Takes further metadata, none of which identifies the patient, from the first slice.
void TakeMetadata(vtkDICOMReader* reader, Volume& volume)
{
  volume.modality = SliceValue(reader, 0, DC::Modality).AsString();
  volume.bodyPart = SliceValue(reader, 0, DC::BodyPartExamined).AsString();
  volume.hasContrastAgent = !SliceValue(reader, 0, DC::ContrastBolusAgent).AsString().empty();
  if (volume.modality == "MR")
  {
    volume.weighting = WeightingOf(reader);
  }
  const double window = SliceValue(reader, 0, DC::WindowWidth).AsDouble();
  if (window > 0)
  {
    volume.windowLevel = { window, SliceValue(reader, 0, DC::WindowCenter).AsDouble() };
  }
  const std::string colours = SliceValue(reader, 0, DC::PhotometricInterpretation).AsString();
  if (colours == "MONOCHROME1" || colours == "PALETTE COLOR")
  {
    volume.warnings.push_back(
      "The photometric interpretation is " + colours + ", which is not converted to brightness.");
  }
}

}

Volume ReadDicom(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  Volume volume;
  ReadProgress scan = progress.Part(0.0, 0.3);
  ReadProgress reading = progress.Part(0.3, 1.0);
  const std::vector<DicomSeries> all = FindDicomSeries(path, volume.warnings, scan);
  const DicomSeries& series = SeriesNamed(path, all, options.series);
  if (options.series.empty() && all.size() > 1)
  {
    volume.warnings.push_back("This is the first of several series: " + SeriesList(all) + ".");
  }

  VtkMessages messages;
  vtkNew<vtkDICOMReader> reader;
  messages.Take(reader);
  messages.Take(reader->GetExecutive());
  messages.Take(reader->GetSorter());
  reader->GetSorter()->SetRepeatsAsTime(1);
  reader->SetFileNames(series.files);
  reader->SetMemoryRowOrderToFileNative();
  // vtk-dicom 0.8.14 swaps big-endian values by the size of the rescaled type.
  reader->AutoRescaleOff();
  ChooseStackAndTime(path, reader, messages, volume.warnings);
  CheckedByteCount(path, LayoutOf(reader));
  ReadSlices(path, reader, messages, reading);

  const ImageGeometry geometry = GeometryOf(reader);
  volume.image = Rescaled(path, reader->GetOutput(), RescaleOf(reader));
  volume.image->GetPointData()->GetScalars()->SetName("scalars");
  PlaceImage(path, geometry, volume.image);
  volume.warnings.insert(
    volume.warnings.end(), messages.Warnings().begin(), messages.Warnings().end());
  const DicomStack stack(reader, geometry);
  volume.irregularSlicesMm = stack.IrregularSlicesMm();
  stack.Warn(options.rectify && !volume.irregularSlicesMm.empty(), volume.warnings);
  WarnOfLoss(reader, volume.warnings);
  TakeMetadata(reader, volume);
  return volume;
}

}
