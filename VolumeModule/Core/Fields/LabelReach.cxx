#include "Core/Fields/LabelReach.h"

#include <glm/common.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr std::uint16_t Farthest = 255;

/// The voxels of a box, visited in index order or in reverse.
class Neighbours
{
public:
  explicit Neighbours(glm::ivec3 size)
    : size(size)
  {
  }

  /// Calls visit(index) for the neighbours that precede a voxel in index order (direction 1) or in
  /// reverse order (-1).
  template <class Visit>
  void Before(glm::ivec3 voxel, int direction, Visit visit) const
  {
    for (int z = -1; z <= 0; ++z)
    {
      for (int y = -1; y <= (z < 0 ? 1 : 0); ++y)
      {
        for (int x = -1; x <= (z < 0 || y < 0 ? 1 : -1); ++x)
        {
          const glm::ivec3 beside = voxel + direction * glm::ivec3(x, y, z);
          if (beside == glm::clamp(beside, glm::ivec3(0), this->size - 1))
          {
            visit(this->Index(beside));
          }
        }
      }
    }
  }

  std::size_t Index(glm::ivec3 voxel) const
  {
    return voxel.x + std::size_t(this->size.x) * (voxel.y + std::size_t(this->size.y) * voxel.z);
  }

private:
  glm::ivec3 size;
};

}

// The path to a voxel with another label leads over a voxel at which the label changes. The
// distance is therefore one more than that of the nearest such voxel, by the two passes of
// Rosenfeld and Pfaltz (Pattern Recognition 1968) over the 26 neighbours.
std::vector<std::uint16_t> LabelReach(const std::vector<std::uint16_t>& labels, glm::ivec3 size)
{
  const Neighbours neighbours(size);
  std::vector<std::uint16_t> reach(labels.size(), Farthest);
  const auto pass = [&](int direction)
  {
    const glm::ivec3 last = size - 1;
    for (int k = 0; k < size.z; ++k)
    {
      for (int j = 0; j < size.y; ++j)
      {
        for (int i = 0; i < size.x; ++i)
        {
          const glm::ivec3 forward(i, j, k);
          const glm::ivec3 voxel = direction > 0 ? forward : last - forward;
          const std::size_t here = neighbours.Index(voxel);
          neighbours.Before(voxel, direction,
            [&](std::size_t beside)
            {
              const bool changes = labels[beside] != labels[here];
              const int least = changes ? 1 : reach[beside] + 1;
              reach[here] = std::uint16_t(std::min(int(reach[here]), least));
            });
        }
      }
    }
  };
  pass(1);
  pass(-1);
  return reach;
}

}
