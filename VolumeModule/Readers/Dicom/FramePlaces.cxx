#include "Readers/Dicom/FramePlaces.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FrameOrder.h"

#include <vtkDICOMDictHash.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{
namespace
{

std::optional<glm::dmat2x3> AxesOf(const DicomAttributes& attributes)
{
  const vtkDICOMTagPath detector(DC::DetectorInformationSequence, 0, DC::ImageOrientationPatient);
  auto axes = attributes.Numbers<glm::dmat2x3>(DC::ImageOrientationPatient);
  axes = axes ? axes : attributes.Numbers<glm::dmat2x3>(DC::ImageOrientationVolume);
  axes = axes ? axes : attributes.Numbers<glm::dmat2x3>(detector);
  if (!axes || glm::length(glm::cross((*axes)[0], (*axes)[1])) < 1e-6)
  {
    return std::nullopt;
  }
  return glm::dmat2x3(glm::normalize((*axes)[0]), glm::normalize((*axes)[1]));
}

std::optional<glm::dvec3> PositionOf(const DicomAttributes& attributes)
{
  const vtkDICOMTagPath detector(DC::DetectorInformationSequence, 0, DC::ImagePositionPatient);
  auto position = attributes.Numbers<glm::dvec3>(DC::ImagePositionPatient);
  position = position ? position : attributes.Numbers<glm::dvec3>(DC::ImagePositionVolume);
  return position ? position : attributes.Numbers<glm::dvec3>(detector);
}

/// Size of the pixels of the first region of an ultrasound image that is measured in cm along both
/// axes: that of a picture of tissue, if there is one, as other regions show traces over time.
std::optional<glm::dvec2> RegionPixelMm(const DicomAttributes& attributes)
{
  constexpr double UnitIsCm = 3.0;
  constexpr double MmPerCm = 10.0;
  constexpr double IsTissue = 1.0;
  const vtkDICOMValue& regions = attributes.Value(DC::SequenceOfUltrasoundRegions);
  std::optional<glm::dvec2> pixelMm;
  for (std::size_t i = 0; regions.IsValid() && i < regions.GetNumberOfValues(); ++i)
  {
    const auto number = [&](vtkDICOMTag tag)
    {
      return attributes.Number(
        vtkDICOMTagPath(DC::SequenceOfUltrasoundRegions, static_cast<unsigned int>(i), tag));
    };
    const auto x = number(DC::PhysicalDeltaX);
    const auto y = number(DC::PhysicalDeltaY);
    const bool isLength = number(DC::PhysicalUnitsXDirection) == UnitIsCm &&
      number(DC::PhysicalUnitsYDirection) == UnitIsCm;
    const bool isTissue = number(DC::RegionSpatialFormat) == IsTissue;
    if (x && y && isLength && (!pixelMm || isTissue))
    {
      pixelMm = MmPerCm * glm::abs(glm::dvec2(*x, *y));
      if (isTissue)
      {
        break;
      }
    }
  }
  return pixelMm;
}

/// Distances of columns and of rows, from the attribute that the kind of file has.
std::optional<glm::dvec2> PixelMmOf(const DicomAttributes& attributes)
{
  const auto isPositive = [](const std::optional<glm::dvec2>& mm)
  { return mm && mm->x > 0.0 && mm->y > 0.0; };
  for (const vtkDICOMTag tag :
    { DC::PixelSpacing, DC::ImagerPixelSpacing, DC::NominalScannedPixelSpacing })
  {
    const auto rowsAndColumnsMm = attributes.Numbers<glm::dvec2>(tag);
    if (isPositive(rowsAndColumnsMm))
    {
      return glm::dvec2(rowsAndColumnsMm->y, rowsAndColumnsMm->x);
    }
  }
  const auto regionMm = RegionPixelMm(attributes);
  return isPositive(regionMm) ? regionMm : std::nullopt;
}

void PlaceFrame(const DicomAttributes& attributes, DicomFrame& frame)
{
  frame.axes = AxesOf(attributes);
  frame.positionMm = PositionOf(attributes);
  frame.isPatientSpace = !attributes.Value(DC::ImagePositionVolume).IsValid();
  frame.pixelMm = PixelMmOf(attributes);
  const auto aspect = attributes.Numbers<glm::dvec2>(DC::PixelAspectRatio);
  frame.pixelAspect = aspect && aspect->x > 0.0 && aspect->y > 0.0 ? aspect->y / aspect->x : 1.0;
  frame.heightMm = attributes.Number(DC::SliceLocation);
  const auto distance = attributes.Number(DC::SpacingBetweenSlices);
  const auto thickness = attributes.Number(DC::SliceThickness);
  frame.isDistanceThickness = !(distance && *distance != 0.0);
  const auto stated = frame.isDistanceThickness ? thickness : distance;
  if (stated && *stated != 0.0)
  {
    frame.distanceMm = *stated;
  }
}

bool HavePlacesOfTheirOwn(vtkDICOMMetaData* meta)
{
  const vtkDICOMValue& groups = meta->Get(DC::PerFrameFunctionalGroupsSequence);
  if (!groups.IsValid() || groups.GetNumberOfValues() == 0)
  {
    return false;
  }
  const DicomAttributes shared(meta, -1);
  const DicomAttributes first(meta, 0);
  return PositionOf(first).has_value() && !PositionOf(shared).has_value();
}

void Stack(const std::vector<double>& offsetsMm, std::vector<DicomFrame>& frames)
{
  for (DicomFrame& frame : frames)
  {
    const double offsetMm = offsetsMm[std::size_t(frame.number)];
    frame.heightMm = offsetMm;
    if (frame.positionMm && frame.axes)
    {
      *frame.positionMm += offsetMm * glm::cross((*frame.axes)[0], (*frame.axes)[1]);
    }
  }
}

/// Makes frames at one place follow each other in time. The times between them are all alike, or
/// each is that since the frame before (PS3.3 C.7.6.5).
void MakeFilm(const DicomAttributes& attributes, std::vector<DicomFrame>& frames)
{
  constexpr double SecondsPerMs = 1e-3;
  const vtkDICOMValue& stepsMs = attributes.Value(DC::FrameTimeVector);
  const auto stepMs = attributes.Number(DC::FrameTime);
  const bool hasSteps = stepsMs.IsValid() &&
    stepsMs.GetNumberOfValues() == std::size_t(frames.front().file->frameCount);
  double seconds = 0.0;
  for (DicomFrame& frame : frames)
  {
    frame.heightMm = 0.0;
    frame.sharesPlace = true;
    frame.differences[std::size_t(DicomDifference::FrameNumber)] = std::to_string(frame.number + 1);
    if (hasSteps)
    {
      seconds += SecondsPerMs * stepsMs.GetDouble(std::size_t(frame.number));
      frame.timeSeconds = seconds;
    }
    else if (stepMs)
    {
      frame.timeSeconds = SecondsPerMs * *stepMs * frame.number;
    }
  }
}

bool IsRadiograph(const DicomFrame& frame)
{
  constexpr const char* Radiographs[] = { "CR", "DX", "MG", "IO", "PX", "RG" };
  const std::string& modality = frame.file->modality;
  return frame.file->frameCount == 1 && !frame.positionMm &&
    std::find(std::begin(Radiographs), std::end(Radiographs), modality) != std::end(Radiographs);
}

/// Makes a radiograph a view by its side, its direction and its number.
void MakeView(const DicomAttributes& attributes, DicomFrame& frame)
{
  std::string& view = frame.differences[std::size_t(DicomDifference::View)];
  for (const vtkDICOMTag tag : { DC::ImageLaterality, DC::ViewPosition, DC::InstanceNumber })
  {
    const std::string text = attributes.Text(tag);
    view += (view.empty() || text.empty() ? "" : " ") + text;
  }
  frame.heightMm = 0.0;
  frame.sharesPlace = true;
}

}

void PlaceFrames(vtkDICOMMetaData* meta, std::vector<DicomFrame>& frames)
{
  for (DicomFrame& frame : frames)
  {
    const DicomAttributes attributes(meta, frame.number);
    PlaceFrame(attributes, frame);
    if (IsRadiograph(frame))
    {
      MakeView(attributes, frame);
    }
  }
  TakeVectors(meta, frames);
  if (frames.empty() || frames.front().file->frameCount == 1 || HavePlacesOfTheirOwn(meta))
  {
    return;
  }
  const std::vector<double> offsetsMm = OffsetsMm(meta, frames);
  if (!offsetsMm.empty())
  {
    Stack(offsetsMm, frames);
    return;
  }
  MakeFilm(DicomAttributes(meta), frames);
}

}
