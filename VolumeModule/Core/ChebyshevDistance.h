#ifndef Varimarch_Core_ChebyshevDistance_h
#define Varimarch_Core_ChebyshevDistance_h

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// Chebyshev distance of every cell of a lattice to a set of them, by the two passes of Rosenfeld
/// and Pfaltz (Pattern Recognition 1968) over the 26 neighbours, which are exact for this distance.
/// Outside the lattice there is none of the set.
class ChebyshevDistance
{
public:
  explicit ChebyshevDistance(glm::ivec3 cellCount)
    : cellCount(cellCount)
    , row(cellCount.x + 2)
    , plane(std::ptrdiff_t(row) * (cellCount.y + 2))
    , distances(std::size_t(plane) * (cellCount.z + 2), Farthest)
    , nearest(cellCount.x)
  {
  }

  std::uint8_t* Row(int y, int z)
  {
    return &this->distances[(z + 1) * this->plane + (y + 1) * this->row + 1];
  }

  /// Rows hold 0 in the set and Farthest elsewhere before; afterwards each cell its distance, 1
  /// beside the set, Farthest at most.
  void Measure()
  {
    for (int z = 0; z < this->cellCount.z; ++z)
    {
      for (int y = 0; y < this->cellCount.y; ++y)
      {
        this->UpdateRow(this->Row(y, z), -1);
      }
    }
    for (int z = this->cellCount.z - 1; z >= 0; --z)
    {
      for (int y = this->cellCount.y - 1; y >= 0; --y)
      {
        this->UpdateRow(this->Row(y, z), 1);
      }
    }
  }

  static constexpr std::uint8_t Farthest = 128;

private:
  // Looks at the 13 neighbours that come before a cell in the direction of the pass.
  void UpdateRow(std::uint8_t* cell, int direction)
  {
    const std::ptrdiff_t y = direction * this->row;
    const std::ptrdiff_t z = direction * this->plane;
    const std::uint8_t* const rows[] = { cell + y, cell + z - this->row, cell + z,
      cell + z + this->row };
    const int width = this->cellCount.x;
    std::fill(this->nearest.begin(), this->nearest.end(), Farthest);
    for (const std::uint8_t* neighbour : rows)
    {
      for (int x = 0; x < width; ++x)
      {
        const std::uint8_t beside = std::min(neighbour[x - 1], neighbour[x + 1]);
        this->nearest[x] = std::min(this->nearest[x], std::min(beside, neighbour[x]));
      }
    }
    const int first = direction < 0 ? 0 : width - 1;
    for (int i = 0; i < width; ++i)
    {
      const int x = first - direction * i;
      const int before = std::min(this->nearest[x], cell[x + direction]);
      cell[x] = std::uint8_t(std::min(int(cell[x]), before + 1));
    }
  }

  glm::ivec3 cellCount;
  std::ptrdiff_t row;
  std::ptrdiff_t plane;
  std::vector<std::uint8_t> distances;
  std::vector<std::uint8_t> nearest;
};

}

#endif
