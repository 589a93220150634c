#include "Readers/Paging/Preview.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace varimarch
{
namespace
{

using Counts = std::array<std::int64_t, 3>;

Counts CountsOf(const Counts& dimensions, const Counts& steps)
{
  Counts counts;
  for (int axis = 0; axis < 3; ++axis)
  {
    counts[axis] = (dimensions[axis] - 1) / steps[axis] + 1;
  }
  return counts;
}

double ProductOf(const Counts& counts)
{
  return double(counts[0]) * double(counts[1]) * double(counts[2]);
}

/// The distances of the voxels that are copied.
Counts StepsFor(const Counts& dimensions, std::size_t voxelBytes, std::uint64_t mostMemoryBytes)
{
  constexpr double PartOfMemory = 0.25;
  const double mostVoxels =
    std::min(double(1 << 24), PartOfMemory * double(mostMemoryBytes) / double(voxelBytes));
  constexpr double MostBytes = 5e8;
  // The system reads ahead, and so most of each slice in which voxels are.
  const auto between =
    std::int64_t(std::ceil(ProductOf(dimensions) * double(voxelBytes) / MostBytes));
  const std::int64_t longest = *std::max_element(dimensions.begin(), dimensions.end());
  for (std::int64_t step = 1;; ++step)
  {
    Counts steps = { step, step, std::max(step, between) };
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis] = std::min(steps[axis], std::max<std::int64_t>(dimensions[axis] - 1, 1));
    }
    if (ProductOf(CountsOf(dimensions, steps)) <= mostVoxels || step >= longest)
    {
      return steps;
    }
  }
}

}

std::string SentenceAboutPreview(const VoxelLayout& copy, const VoxelLayout& volume)
{
  return "A coarse copy, " + Text(copy) + ", is shown, since the volume, " + Text(volume) +
    ", was not read before; no error of the image is promised.";
}

vtkSmartPointer<vtkImageData> CoarseCopy(const BrickSource& source, const VoxelLayout& layout,
  const Mapping& mapping, ReadProgress& progress)
{
  const auto voxelBytes = std::size_t(vtkDataArray::GetDataTypeSize(layout.scalarType));
  const Counts steps = StepsFor(layout.dimensions, voxelBytes, mapping.mostMemoryBytes);
  PreviewWish& wish = *mapping.preview;
  VoxelLayout ofCopy = layout;
  ofCopy.dimensions = CountsOf(layout.dimensions, steps);
  std::copy(steps.begin(), steps.end(), std::begin(wish.steps));
  const Counts& count = ofCopy.dimensions;
  const auto copy = AllocatedImage(ofCopy);
  char* to = static_cast<char*>(copy->GetScalarPointer());
  std::vector<char> row(std::size_t(layout.dimensions[0]) * voxelBytes);
  for (std::int64_t z = 0; z < count[2]; ++z)
  {
    progress.Report(double(z) / double(count[2]));
    for (std::int64_t y = 0; y < count[1]; ++y)
    {
      const Counts first = { 0, y * steps[1], z * steps[2] };
      source.Read(0, { first, { layout.dimensions[0], first[1] + 1, first[2] + 1 } }, row.data());
      for (std::int64_t x = 0; x < count[0]; ++x, to += voxelBytes)
      {
        std::memcpy(to, row.data() + std::size_t(x * steps[0]) * voxelBytes, voxelBytes);
      }
    }
  }
  wish.sentence = SentenceAboutPreview(ofCopy, layout);
  return copy;
}

}
