#include "Readers/Dicom/DicomStack.h"

#include "Readers/NumberText.h"
#include "Readers/VolumeFile.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

constexpr int MostGapsNamed = 3;

/// Part of the usual distance by which distances may vary in an even stack.
constexpr double EvenPart = 0.01;

}

DicomStack::DicomStack(const DicomSlices& slices)
  : slices(slices)
{
  const DicomFrame& first = slices.frames.front();
  const glm::dvec2 pixelMm = first.pixelMm.value_or(glm::dvec2(first.pixelAspect, 1.0));
  const glm::dmat2x3 axes = first.axes.value_or(glm::dmat2x3(1.0));
  this->normal = glm::normalize(glm::cross(axes[0], axes[1]));
  this->geometry.axesMm[0] = axes[0] * pixelMm.x;
  this->geometry.axesMm[1] = axes[1] * pixelMm.y;
  this->geometry.originMm = first.positionMm.value_or(glm::dvec3(0.0));
  this->MeasureDistances();
  this->PlaceSlices();
}

/// The distance of an even stack is the mean one, which is more exact than a single one; that of an
/// uneven stack is the median, which a few gaps do not change.
void DicomStack::MeasureDistances()
{
  const std::vector<double>& heightsMm = this->slices.heightsMm;
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    this->gapsMm.push_back(heightsMm[i] - heightsMm[i - 1]);
  }
  if (this->gapsMm.empty())
  {
    this->drawnMm = std::abs(this->slices.frames.front().distanceMm.value_or(1.0));
    return;
  }
  this->drawnMm = UsualDistanceMm(heightsMm);
  if (!this->IsUneven())
  {
    this->drawnMm = (heightsMm.back() - heightsMm.front()) / double(this->gapsMm.size());
  }
}

void DicomStack::PlaceSlices()
{
  const std::vector<DicomFrame>& frames = this->slices.frames;
  const std::vector<double>& heightsMm = this->slices.heightsMm;
  const double heightMm = heightsMm.back() - heightsMm.front();
  glm::dvec3 directionOfStack = this->normal;
  if (this->slices.hasPositions && heightMm > 0.0)
  {
    directionOfStack = (*frames.back().positionMm - *frames.front().positionMm) / heightMm;
  }
  this->geometry.axesMm[2] = directionOfStack * this->drawnMm;
  this->tiltDegrees = glm::degrees(std::acos(std::min(1.0, 1.0 / glm::length(directionOfStack))));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const glm::dvec3 straightMm =
      this->geometry.originMm + directionOfStack * (heightsMm[i] - heightsMm.front());
    this->positionsMm.push_back(this->slices.hasPositions ? *frames[i].positionMm : straightMm);
    this->crookedMm =
      std::max(this->crookedMm, glm::distance(this->positionsMm.back(), straightMm));
  }
}

bool DicomStack::IsTilted() const
{
  return this->tiltDegrees > 0.1;
}

bool DicomStack::IsUneven() const
{
  const auto [narrowest, widest] = std::minmax_element(this->gapsMm.begin(), this->gapsMm.end());
  return !this->gapsMm.empty() && *widest - *narrowest > EvenPart * this->drawnMm;
}

bool DicomStack::IsCrooked() const
{
  return this->crookedMm > 0.5 * glm::length(this->geometry.axesMm[0]);
}

std::vector<glm::dvec3> DicomStack::IrregularSlicesMm() const
{
  const bool isIrregular =
    !this->gapsMm.empty() && (this->IsTilted() || this->IsUneven() || this->IsCrooked());
  return isIrregular ? this->positionsMm : std::vector<glm::dvec3>();
}

bool DicomStack::IsMisplaced() const
{
  constexpr double MostOfUsual = 4.0;
  const auto isSmall = [&](double gapMm) { return gapMm <= MostOfUsual * this->drawnMm; };
  return this->slices.hasPositions && (this->IsUneven() || this->IsCrooked()) &&
    std::all_of(this->gapsMm.begin(), this->gapsMm.end(), isSmall);
}

void DicomStack::Warn(bool isRectified, std::vector<std::string>& warnings) const
{
  const DicomFrame& first = this->slices.frames.front();
  if (!first.axes || !first.isPatientSpace)
  {
    warnings.push_back(UnknownSides);
  }
  if (!first.pixelMm)
  {
    warnings.push_back("The file does not say how large a pixel is; 1 mm was taken.");
  }
  if (this->IsTilted())
  {
    const bool isDrawnTrue = !isRectified && !this->IsUneven();
    warnings.push_back("The gantry was tilted by " + ShortText(this->tiltDegrees) + " degrees" +
      (isDrawnTrue ? "; each slice is drawn at its true position, so shapes are correct." : "."));
  }
  this->WarnOfMissingSlices(warnings);
  if (this->IsUneven())
  {
    warnings.push_back(this->UnevenDistances() +
      (isRectified ? "." : ", but are drawn " + ShortText(this->drawnMm) + " mm apart."));
  }
  if (this->IsCrooked())
  {
    warnings.push_back("Slices lie up to " + ShortText(this->crookedMm) +
      " mm beside the straight line from the first to the last" +
      (isRectified ? "." : ", but are drawn on it."));
  }
}

/// Adds one sentence for each of the first gaps of one or more missing slices.
void DicomStack::WarnOfMissingSlices(std::vector<std::string>& warnings) const
{
  int count = 0;
  for (std::size_t gap = 0; gap < this->gapsMm.size(); ++gap)
  {
    const auto missing = std::lround(this->gapsMm[gap] / this->drawnMm) - 1;
    if (missing >= 1 && ++count <= MostGapsNamed)
    {
      warnings.push_back((missing == 1 ? "A slice is" : std::to_string(missing) + " slices are") +
        " missing between " + this->NamesOfGap(gap) + ".");
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
  const auto [narrowest, widest] = std::minmax_element(this->gapsMm.begin(), this->gapsMm.end());
  return "Slices are " + ShortText(*narrowest) + " to " + ShortText(*widest) +
    " mm apart, farthest between " + this->NamesOfGap(std::size_t(widest - this->gapsMm.begin()));
}

std::string DicomStack::NamesOfGap(std::size_t gap) const
{
  return FrameName(this->slices.frames[gap]) + " and " + FrameName(this->slices.frames[gap + 1]);
}

}
