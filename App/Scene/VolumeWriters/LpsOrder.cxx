// Volumes for formats that hold no directions.
#include "Scene/VolumeWriters/ZarrFolder.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace varimarch
{

namespace
{

using Index = std::array<std::int64_t, 3>;

/// The axes of a volume in another order, some of them backwards.
struct Order
{
  std::array<int, 3> axes = { 0, 1, 2 }; ///< for each new axis, the old one
  std::array<bool, 3> isBackwards = { false, false, false };
};

/// The order in which each axis lies as near as possible to that of the world, forwards.
Order NearestOrder(const glm::dmat3& direction)
{
  std::array<int, 3> axes = { 0, 1, 2 };
  Order order;
  double best = -1.0;
  do
  {
    double sum = 0.0;
    for (int world = 0; world < 3; ++world)
    {
      sum += std::abs(direction[axes[world]][world]);
    }
    constexpr double Rounding = 1e-9;
    if (sum > best + Rounding)
    {
      best = sum;
      order.axes = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  for (int world = 0; world < 3; ++world)
  {
    order.isBackwards[world] = direction[order.axes[world]][world] < 0.0;
  }
  return order;
}

/// The first voxel of a box of the new axes along an old one, and the voxel behind its last.
std::array<std::int64_t, 2> Along(
  std::int64_t count, bool isBackwards, std::int64_t lower, std::int64_t upper)
{
  return isBackwards ? std::array<std::int64_t, 2>{ count - upper, count - lower }
                     : std::array<std::int64_t, 2>{ lower, upper };
}

/// Reads a box of the new axes.
void ReadInOrder(const ZarrInput& input, const Order& order, std::size_t voxelBytes,
  const Index& lower, const Index& upper, void* voxels)
{
  Index from;
  Index to;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    const auto [first, end] =
      Along(input.dimensions[axis], order.isBackwards[world], lower[world], upper[world]);
    from[axis] = first;
    to[axis] = end;
  }
  const Index size = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  std::vector<char> box(std::size_t(size[0] * size[1] * size[2]) * voxelBytes);
  input.read(from, to, box.data());
  const Index steps = { 1, size[0], size[0] * size[1] };
  Index newSteps;
  std::int64_t first = 0;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    newSteps[world] = order.isBackwards[world] ? -steps[axis] : steps[axis];
    first += order.isBackwards[world] ? (size[axis] - 1) * steps[axis] : 0;
  }
  char* destination = static_cast<char*>(voxels);
  for (std::int64_t k = 0; k < upper[2] - lower[2]; ++k)
  {
    for (std::int64_t j = 0; j < upper[1] - lower[1]; ++j)
    {
      std::int64_t place = first + k * newSteps[2] + j * newSteps[1];
      for (std::int64_t i = lower[0]; i < upper[0]; ++i, place += newSteps[0])
      {
        std::memcpy(destination, box.data() + std::size_t(place) * voxelBytes, voxelBytes);
        destination += voxelBytes;
      }
    }
  }
}

}

ZarrInput InLpsOrder(const ZarrInput& input)
{
  const Order order = NearestOrder(input.direction);
  ZarrInput turned = input;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    const bool isBackwards = order.isBackwards[world];
    turned.dimensions[world] = input.dimensions[axis];
    turned.spacingMm[world] = input.spacingMm[axis];
    turned.direction[world] = isBackwards ? -input.direction[axis] : input.direction[axis];
    turned.originMm += isBackwards
      ? double(input.dimensions[axis] - 1) * input.spacingMm[axis] * input.direction[axis]
      : glm::dvec3(0.0);
  }
  const std::size_t voxelBytes = std::size_t(vtkDataArray::GetDataTypeSize(input.scalarType)) *
    std::size_t(input.componentCount);
  const bool isSame = order.axes == Order().axes && order.isBackwards == Order().isBackwards;
  if (!isSame)
  {
    turned.read = [=](const Index& lower, const Index& upper, void* voxels)
    { ReadInOrder(input, order, voxelBytes, lower, upper, voxels); };
  }
  return turned;
}

}
