#include "Scene/SlabSampler.h"

#include "Scene/SliceGrid.h"

#include <vtkImageData.h>
#include <vtkImageInterpolator.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

SlabSampler::SlabSampler(vtkImageData* image, const SlabLook& look)
  : look(look)
  , extent(image->GetExtent())
{
  const double* const spacing = image->GetSpacing();
  this->stepMm = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  // Farther from the middle of the slab than the volume is long there are no samples.
  const double halfMm = std::min(0.5 * look.slabMm, image->GetLength());
  this->steps = int(std::ceil(halfMm / this->stepMm));
  this->interpolator->SetInterpolationModeToLinear();
  this->interpolator->SetComponentCount(1); // volumes of colours have several
  this->interpolator->Initialize(image);
}

SlabSampler::~SlabSampler() = default;

std::uint8_t SlabSampler::GrayAt(const glm::dvec3& index, const glm::dvec3& through) const
{
  const std::optional<double> value = this->BlendedThrough(index, through);
  if (!value || std::isnan(*value))
  {
    return 0;
  }
  const double part = (*value - this->look.level) / this->look.window + 0.5;
  const double gray = std::clamp(part, 0.0, 1.0);
  return std::uint8_t(std::lround(255.0 * (this->look.inverted ? 1.0 - gray : gray)));
}

std::optional<double> SlabSampler::BlendedThrough(
  const glm::dvec3& index, const glm::dvec3& through) const
{
  std::optional<double> blended;
  int count = 0;
  for (int step = -this->steps; step <= this->steps; ++step)
  {
    if (const auto value = this->ValueAt(index + double(step) * through))
    {
      blended = blended ? this->Blended(*blended, *value) : *value;
      ++count;
    }
  }
  return blended && this->look.slabBlend == SlabBlend::Mean ? *blended / count : blended;
}

double SlabSampler::Blended(double a, double b) const
{
  switch (this->look.slabBlend)
  {
    case SlabBlend::Minimum:
      return std::min(a, b);
    case SlabBlend::Mean:
      return a + b;
    default:
      return std::max(a, b);
  }
}

std::optional<double> SlabSampler::ValueAt(const glm::dvec3& index) const
{
  if (!IsWithin(index, this->extent))
  {
    return std::nullopt;
  }
  double value;
  this->interpolator->InterpolateIJK(&index.x, &value);
  return value;
}

}
