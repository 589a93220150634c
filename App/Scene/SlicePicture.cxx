#include "Scene/SlicePicture.h"

#include "Scene/SlabSampler.h"
#include "Scene/SliceGrid.h"

#include <vtkImageData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace varimarch
{

namespace
{

// The part of the range of a PET scan that its slices and the preset pet-maximum show.
constexpr double PetPartShown = 0.5;

bool IsPet(const LoadedVolume& volume)
{
  return volume.modality == "PT";
}

}

std::array<double, 2> AutomaticWindow(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  // Organs that excrete the tracer are many times brighter than the body.
  const bool isPet = IsPet(volume);
  const double first = isPet ? 0.0 : statistics.Percentile(0.1);
  const double last = (isPet ? PetPartShown : 1.0) * statistics.Percentile(99.9);
  return { std::max(last - first, 1e-6), 0.5 * (first + last) };
}

SliceGrays SuggestedGrays(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  return { volume.windowLevel ? *volume.windowLevel : AutomaticWindow(volume, statistics),
    IsPet(volume) || volume.isInverted };
}

std::vector<std::uint8_t> SlicePicture(vtkImageData* image, const SliceRequest& request)
{
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height);
  const SliceGrid grid(image, request);
  const SlabSampler sampler(
    image, { request.window, request.level, request.slabMm, request.slabBlend, request.inverted });
  const glm::dvec3 through = grid.Through(sampler.StepMm());
  tbb::parallel_for(tbb::blocked_range<int>(0, request.height),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column < request.width; ++column)
        {
          pixels[std::size_t(row) * request.width + column] =
            sampler.GrayAt(grid.IndexAt(column, row), through);
        }
      }
    });
  return pixels;
}

}
