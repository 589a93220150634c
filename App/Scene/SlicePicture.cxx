#include "Scene/SlicePicture.h"

#include "Scene/SliceGrid.h"

#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkNew.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace varimarch
{

namespace
{

// The part of the range of a PET scan that its slices and the preset pet-maximum show.
constexpr double PetPartShown = 0.5;

class SliceSampler
{
public:
  SliceSampler(vtkImageData* image, const SliceRequest& request)
    : request(request)
    , grid(image, request)
  {
    const double* const spacing = image->GetSpacing();
    const double stepMm = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
    this->slabSteps = int(std::ceil(0.5 * request.slabMm / stepMm));
    this->through = this->grid.Through(stepMm);
    this->interpolator->SetInterpolationModeToLinear();
    this->interpolator->Initialize(image);
  }

  void DrawRow(int row, std::uint8_t* pixels) const
  {
    for (int column = 0; column < this->request.width; ++column)
    {
      pixels[column] = this->GrayOf(this->BlendedThrough(this->grid.IndexAt(column, row)));
    }
  }

private:
  std::optional<double> BlendedThrough(const glm::dvec3& index) const
  {
    std::optional<double> blended;
    int count = 0;
    for (int step = -this->slabSteps; step <= this->slabSteps; ++step)
    {
      if (const auto value = this->ValueAt(index + double(step) * this->through))
      {
        blended = blended ? this->Blended(*blended, *value) : *value;
        ++count;
      }
    }
    return blended && this->request.slabBlend == SlabBlend::Mean ? *blended / count : blended;
  }

  double Blended(double a, double b) const
  {
    switch (this->request.slabBlend)
    {
      case SlabBlend::Minimum:
        return std::min(a, b);
      case SlabBlend::Mean:
        return a + b;
      default:
        return std::max(a, b);
    }
  }

  std::optional<double> ValueAt(const glm::dvec3& index) const
  {
    if (!this->grid.Holds(index))
    {
      return std::nullopt;
    }
    double value;
    this->interpolator->InterpolateIJK(&index.x, &value);
    return value;
  }

  std::uint8_t GrayOf(std::optional<double> value) const
  {
    if (!value || std::isnan(*value))
    {
      return 0;
    }
    const double part = (*value - this->request.level) / this->request.window + 0.5;
    const double gray = std::clamp(part, 0.0, 1.0);
    return std::uint8_t(std::lround(255.0 * (this->request.inverted ? 1.0 - gray : gray)));
  }

  const SliceRequest& request;
  SliceGrid grid;
  int slabSteps;
  glm::dvec3 through;
  vtkNew<vtkImageInterpolator> interpolator;
};

}

SliceGrays SuggestedGrays(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  const bool isPet = volume.modality == "PT";
  if (volume.windowLevel)
  {
    return { *volume.windowLevel, isPet };
  }
  // Organs that excrete the tracer are many times brighter than the body.
  const double first = isPet ? 0.0 : statistics.Percentile(0.1);
  const double last = (isPet ? PetPartShown : 1.0) * statistics.Percentile(99.9);
  return { { std::max(last - first, 1e-6), 0.5 * (first + last) }, isPet };
}

std::vector<std::uint8_t> SlicePicture(vtkImageData* image, const SliceRequest& request)
{
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height);
  const SliceSampler sampler(image, request);
  tbb::parallel_for(tbb::blocked_range<int>(0, request.height),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        sampler.DrawRow(row, pixels.data() + std::size_t(row) * request.width);
      }
    });
  return pixels;
}

}
