#ifndef Varimarch_Testing_CellFieldByBruteForce_h
#define Varimarch_Testing_CellFieldByBruteForce_h

#include "Core/Fields/CellField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace varimarch
{

/// A volume that owns its voxels.
template <class Scalar>
struct OwnedVolume
{
  glm::ivec3 dimensions;
  std::vector<Scalar> voxels;

  ScalarGrid<Scalar> Grid() const { return { voxels.data(), dimensions }; }
};

/// Difference of the extreme voxels of a block in long double, which is exact for all types here.
template <class Scalar>
long double BlockVariation(const OwnedVolume<Scalar>& volume, glm::ivec3 cell, int radius)
{
  const glm::ivec3 lower = glm::max(cell - radius, glm::ivec3(0));
  const glm::ivec3 upper = glm::min(cell + radius + 1, volume.dimensions - 1);
  long double lowest = std::numeric_limits<long double>::infinity();
  long double highest = -lowest;
  for (int z = lower.z; z <= upper.z; ++z)
  {
    for (int y = lower.y; y <= upper.y; ++y)
    {
      for (int x = lower.x; x <= upper.x; ++x)
      {
        const Scalar voxel = volume.Grid().Voxel({ x, y, z });
        if (!std::isfinite(double(voxel)))
        {
          return std::numeric_limits<long double>::infinity();
        }
        lowest = std::min<long double>(lowest, voxel);
        highest = std::max<long double>(highest, voxel);
      }
    }
  }
  return highest - lowest;
}

/// The definition, by trying one radius after the other.
template <class Scalar>
int SizeByBruteForce(const OwnedVolume<Scalar>& volume, glm::ivec3 cell, double tolerance)
{
  const long double limit = std::min(tolerance, std::numeric_limits<double>::max());
  const int whole = std::max({ volume.dimensions.x, volume.dimensions.y, volume.dimensions.z });
  int size = 0;
  while (size <= CellField::LargestRadius && size <= whole &&
    BlockVariation(volume, cell, size) <= limit)
  {
    ++size;
  }
  return size > whole ? CellField::LargestRadius + 1 : size;
}

}

#endif
