// DICOM through vtk-dicom: sorts slices by position, reads compressed and multi-frame files.
#include "Readers/DicomSeries.h"
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
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace varimarch
{
namespace
{

/// While it lives, std::cerr prints nothing. GDCM, which decodes compressed slices for vtk-dicom,
/// writes there what vtk-dicom reports as an error anyway.
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

/// Reads the slices in the order of the information.
void ReadSlices(const std::string& path, vtkDICOMReader* reader, const VtkMessages& messages,
  ReadProgress& progress)
{
  {
    const SilentErrorStream silent;
    UpdateWithProgress(reader, progress);
  }
  if (!messages.Errors().empty())
  {
    FailToRead(path, "complete DICOM images", messages.FirstErrorOr("others"));
  }
}

const DicomSeries& ChosenSeries(
  const std::string& path, const std::vector<DicomSeries>& all, const std::string& uid)
{
  const auto chosen = uid.empty()
    ? std::max_element(all.begin(), all.end(),
        [](const DicomSeries& a, const DicomSeries& b) { return a.imageCount < b.imageCount; })
    : std::find_if(
        all.begin(), all.end(), [&](const DicomSeries& series) { return series.uid == uid; });
  if (chosen == all.end())
  {
    FailToRead(path, "the series " + Quoted(uid), std::to_string(all.size()) + " others");
  }
  return *chosen;
}

/// Attribute of the file and frame that a slice came from.
const vtkDICOMValue& SliceValue(vtkDICOMReader* reader, int slice, vtkDICOMTag tag)
{
  const int file = int(reader->GetFileIndexArray()->GetComponent(slice, 0));
  const int frame = int(reader->GetFrameIndexArray()->GetComponent(slice, 0));
  return reader->GetMetaData()->Get(file, frame, tag);
}

int SliceCount(vtkDICOMReader* reader)
{
  return int(reader->GetFileIndexArray()->GetNumberOfTuples());
}

/// Reads the headers of the files and puts them in order.
void UpdateInformation(const std::string& path, vtkDICOMReader* reader, const VtkMessages& messages)
{
  reader->UpdateInformation();
  if (!messages.Errors().empty())
  {
    FailToRead(path, "a series of DICOM images of one kind", messages.FirstErrorOr("others"));
  }
}

/// A series may hold several stacks of slices, and several times: takes the largest, and the first.
void ChooseStackAndTime(const std::string& path, vtkDICOMReader* reader,
  const VtkMessages& messages, std::vector<std::string>& warnings)
{
  UpdateInformation(path, reader, messages);
  const auto stackCount = reader->GetStackIDs()->GetNumberOfValues();
  if (stackCount > 1)
  {
    std::vector<std::string> ids;
    for (vtkIdType i = 0; i < stackCount; ++i)
    {
      ids.push_back(reader->GetStackIDs()->GetValue(i));
    }
    std::string largest;
    int largestCount = 0;
    for (const std::string& id : ids)
    {
      reader->SetDesiredStackID(id.c_str());
      UpdateInformation(path, reader, messages);
      largest = SliceCount(reader) > largestCount ? id : largest;
      largestCount = std::max(largestCount, SliceCount(reader));
    }
    reader->SetDesiredStackID(largest.c_str());
    warnings.push_back("The series has " + std::to_string(stackCount) +
      " stacks of slices; only the largest was read.");
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

/// The patient matrix takes mm along the axes of the image to LPS; it shears for a tilted gantry.
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

/// Where the first pixel of a slice lies, as far as the file says it.
glm::dvec3 PositionMm(vtkDICOMReader* reader, int slice)
{
  const vtkDICOMValue& value = SliceValue(reader, slice, DC::ImagePositionPatient);
  glm::dvec3 positionMm(0.0);
  if (value.GetNumberOfValues() == 3)
  {
    value.GetValues(&positionMm[0], 3);
  }
  return positionMm;
}

/// Gantry tilt, and slices that do not lie at equal distances although they are drawn so.
void WarnOfGeometry(
  vtkDICOMReader* reader, const ImageGeometry& geometry, std::vector<std::string>& warnings)
{
  if (!SliceValue(reader, 0, DC::ImageOrientationPatient).IsValid())
  {
    warnings.push_back(UnknownSides);
    return;
  }
  const glm::dvec3 normal = glm::normalize(glm::cross(geometry.axesMm[0], geometry.axesMm[1]));
  const double drawnMm = glm::dot(geometry.axesMm[2], normal);
  const double tilt = std::acos(std::min(1.0, drawnMm / glm::length(geometry.axesMm[2])));
  std::ostringstream text;
  text.precision(4);
  if (glm::degrees(tilt) > 0.1)
  {
    text << "The gantry was tilted by " << glm::degrees(tilt) << " degrees.";
    warnings.push_back(text.str());
    text.str("");
  }

  double smallestMm = drawnMm;
  double largestMm = drawnMm;
  double lastMm = 0.0;
  for (int slice = 0; slice < SliceCount(reader); ++slice)
  {
    const double locationMm = glm::dot(PositionMm(reader, slice), normal);
    if (slice > 0)
    {
      smallestMm = std::min(smallestMm, locationMm - lastMm);
      largestMm = std::max(largestMm, locationMm - lastMm);
    }
    lastMm = locationMm;
  }
  if (largestMm - smallestMm > 0.01 * drawnMm)
  {
    text << "Slices lie " << smallestMm << " to " << largestMm << " mm apart, but are drawn "
         << drawnMm << " mm apart.";
    warnings.push_back(text.str());
  }
}

/// What else the first slice says: nothing that identifies the patient.
void TakeMetadata(vtkDICOMReader* reader, Volume& volume)
{
  volume.modality = SliceValue(reader, 0, DC::Modality).AsString();
  volume.description = SliceValue(reader, 0, DC::BodyPartExamined).AsString();
  const bool hasContrast = !SliceValue(reader, 0, DC::ContrastBolusAgent).AsString().empty();
  volume.description += hasContrast ? " with contrast agent" : "";
  const double window = SliceValue(reader, 0, DC::WindowWidth).AsDouble();
  if (window > 0)
  {
    volume.windowLevel = { window, SliceValue(reader, 0, DC::WindowCenter).AsDouble() };
  }
  const std::string colours = SliceValue(reader, 0, DC::PhotometricInterpretation).AsString();
  if (colours == "MONOCHROME1" || colours == "PALETTE COLOR")
  {
    volume.warnings.push_back(
      "The values are of the kind " + colours + ", which is not turned into brightness here.");
  }
  if (SliceValue(reader, 0, DC::LossyImageCompression).AsString() == "01")
  {
    volume.warnings.push_back("The images were compressed with loss.");
  }
}

}

Volume ReadDicom(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  Volume volume;
  ReadProgress scan = progress.Part(0.0, 0.3);
  ReadProgress reading = progress.Part(0.3, 1.0);
  const std::vector<DicomSeries> all = FindDicomSeries(path, volume.warnings, scan);
  const DicomSeries& series = ChosenSeries(path, all, options.seriesUid);

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
  WarnOfGeometry(reader, geometry, volume.warnings);
  TakeMetadata(reader, volume);
  return volume;
}

}
