#include "Readers/DicomStack.h"

#include "Readers/DicomSlices.h"
#include "Readers/FileError.h"
#include "Readers/VolumeFile.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMReader.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace varimarch
{
namespace
{

constexpr int MostGapsNamed = 3;

/// Position of the first pixel of a slice; 0 if the file does not state it.
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

std::string Rounded(double number)
{
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

}

DicomStack::DicomStack(vtkDICOMReader* reader, const ImageGeometry& geometry)
  : isPlaced(SliceValue(reader, 0, DC::ImageOrientationPatient).IsValid())
{
  const glm::dvec3 normal = glm::normalize(glm::cross(geometry.axesMm[0], geometry.axesMm[1]));
  this->drawnMm = glm::dot(geometry.axesMm[2], normal);
  this->tiltDegrees =
    glm::degrees(std::acos(std::min(1.0, this->drawnMm / glm::length(geometry.axesMm[2]))));
  this->narrowestMm = this->drawnMm;
  this->widestMm = this->drawnMm;
  for (int slice = 0; slice < SliceCount(reader); ++slice)
  {
    this->positionsMm.push_back(PositionMm(reader, slice));
    if (slice > 0)
    {
      const glm::dvec3 stepMm = this->positionsMm[slice] - this->positionsMm[slice - 1];
      this->gaps.push_back({ glm::dot(stepMm, normal),
        Quoted(SliceFileName(reader, slice - 1)) + " and " +
          Quoted(SliceFileName(reader, slice)) });
      this->narrowestMm = std::min(this->narrowestMm, this->gaps.back().widthMm);
      this->widestMm = std::max(this->widestMm, this->gaps.back().widthMm);
    }
  }
}

bool DicomStack::IsTilted() const
{
  return this->isPlaced && this->tiltDegrees > 0.1;
}

bool DicomStack::IsUneven() const
{
  return this->isPlaced && this->widestMm - this->narrowestMm > 0.01 * this->drawnMm;
}

std::vector<glm::dvec3> DicomStack::IrregularSlicesMm() const
{
  // Slices at the same place or without a position have no order for interpolation.
  const bool areInOrder = this->narrowestMm > 0.0 && !this->gaps.empty();
  const bool isIrregular = areInOrder && (this->IsTilted() || this->IsUneven());
  return isIrregular ? this->positionsMm : std::vector<glm::dvec3>();
}

void DicomStack::Warn(bool isRectified, std::vector<std::string>& warnings) const
{
  if (!this->isPlaced)
  {
    warnings.push_back(UnknownSides);
    return;
  }
  if (this->IsTilted())
  {
    const bool isDrawnTrue = !isRectified && !this->IsUneven();
    warnings.push_back("The gantry was tilted by " + Rounded(this->tiltDegrees) + " degrees" +
      (isDrawnTrue ? "; each slice is drawn at its true position, so shapes are correct." : "."));
  }
  this->WarnOfMissingSlices(warnings);
  if (this->IsUneven())
  {
    warnings.push_back(this->UnevenDistances() +
      (isRectified ? "." : ", but are drawn " + Rounded(this->drawnMm) + " mm apart."));
  }
}

/// Adds one sentence for each of the first gaps of one or more missing slices.
void DicomStack::WarnOfMissingSlices(std::vector<std::string>& warnings) const
{
  int count = 0;
  for (const Gap& gap : this->gaps)
  {
    const int missing = int(std::lround(gap.widthMm / this->drawnMm)) - 1;
    if (missing >= 1 && ++count <= MostGapsNamed)
    {
      warnings.push_back((missing == 1 ? "A slice is" : std::to_string(missing) + " slices are") +
        " missing between " + gap.between + ".");
    }
  }
  if (count > MostGapsNamed)
  {
    warnings.push_back(
      "Slices are missing in " + std::to_string(count - MostGapsNamed) + " more places.");
  }
}

std::string DicomStack::UnevenDistances() const
{
  const auto isNarrower = [](const Gap& a, const Gap& b) { return a.widthMm < b.widthMm; };
  const auto [narrowest, widest] =
    std::minmax_element(this->gaps.begin(), this->gaps.end(), isNarrower);
  return "Slices are " + Rounded(narrowest->widthMm) + " to " + Rounded(widest->widthMm) +
    " mm apart, farthest between " + widest->between;
}

}
