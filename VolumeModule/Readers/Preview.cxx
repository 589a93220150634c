#include "Readers/Preview.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace varimarch
{
namespace
{

using Counts = std::array<std::int64_t, 3>;

/// The distances of the voxels that are copied.
Counts StepsFor(const Counts& dimensions, std::size_t voxelBytes, std::uint64_t mostMemoryBytes)
{
  constexpr double PartOfMemory = 0.25;
  const double mostVoxels =
    std::min(double(1 << 24), PartOfMemory * double(mostMemoryBytes) / double(voxelBytes));
  constexpr double MostBytes = 5e8;
  const double voxels = double(dimensions[0]) * double(dimensions[1]) * double(dimensions[2]);
  const auto step = std::int64_t(std::ceil(std::cbrt(voxels / mostVoxels)));
  // The system reads ahead, and so most of each slice in which voxels are.
  const auto between = std::int64_t(std::ceil(voxels * double(voxelBytes) / MostBytes));
  Counts steps = { step, step, std::max(step, between) };
  for (int axis = 0; axis < 3; ++axis)
  {
    steps[axis] = std::min(steps[axis], std::max<std::int64_t>(dimensions[axis] - 1, 1));
  }
  return steps;
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
  for (int axis = 0; axis < 3; ++axis)
  {
    ofCopy.dimensions[axis] = (layout.dimensions[axis] - 1) / steps[axis] + 1;
    wish.steps[axis] = double(steps[axis]);
  }
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
