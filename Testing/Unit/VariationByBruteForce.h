#ifndef Varimarch_Testing_VariationByBruteForce_h
#define Varimarch_Testing_VariationByBruteForce_h

#include "CellFieldByBruteForce.h"

#include "Core/Fields/VariationField.h"

#include <glm/common.hpp>

namespace varimarch
{

/// True if |p - q| < distance, computed in whole numbers.
inline bool IsCloser(glm::ivec3 p, glm::ivec3 q, int distance, VoxelDistance kind)
{
  const glm::ivec3 apart = glm::abs(p - q);
  return kind == VoxelDistance::Chebyshev
    ? std::max({ apart.x, apart.y, apart.z }) < distance
    : apart.x * apart.x + apart.y * apart.y + apart.z * apart.z < distance * distance;
}

/// The definition: the largest distance for which no closer voxel differs by E or more.
template <class Scalar>
int DistanceByBruteForce(
  const OwnedVolume<Scalar>& volume, glm::ivec3 voxel, double tolerance, VoxelDistance kind)
{
  int largest = VariationField::Farthest;
  const double value = double(volume.Grid().Voxel(voxel));
  std::size_t i = 0;
  for (int z = 0; z < volume.dimensions.z; ++z)
  {
    for (int y = 0; y < volume.dimensions.y; ++y)
    {
      for (int x = 0; x < volume.dimensions.x; ++x, ++i)
      {
        const glm::ivec3 other(x, y, z);
        const bool differs = !(std::abs(double(volume.voxels[i]) - value) < tolerance);
        while (differs && other != voxel && IsCloser(voxel, other, largest, kind))
        {
          --largest;
        }
      }
    }
  }
  return largest;
}

}

#endif
