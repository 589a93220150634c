#ifndef Varimarch_Core_Fields_ChebyshevDistance_h
#define Varimarch_Core_Fields_ChebyshevDistance_h

#include <glm/vec3.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// Chebyshev distance of every cell of a lattice to a set of them, by the two passes of Rosenfeld
/// and Pfaltz (Pattern Recognition 1968) over the 26 neighbours, which are exact for this distance.
/// It may be to what lies towards some directions only: of the neighbours those are then left out
/// that lie behind. Distances are still exact, for they are lengths of paths over neighbours, whose
/// steps may be taken in any order.
/// Outside the lattice there is none of the set. A row waits for those before it in its plane and
/// in the plane before, so that rows whose y + 2 z is the same are measured on all cores.
class ChebyshevDistance
{
public:
  /// @param towards  along each axis 1 or -1, or 0 for both ways
  explicit ChebyshevDistance(glm::ivec3 cellCount, glm::ivec3 towards = glm::ivec3(0))
    : cellCount(cellCount)
    , towards(towards)
    , row(cellCount.x + 2)
    , plane(std::ptrdiff_t(row) * (cellCount.y + 2))
    , distances(std::size_t(plane) * (cellCount.z + 2), Farthest)
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
    const int waves = this->cellCount.y + 2 * (this->cellCount.z - 1);
    for (int wave = 0; wave < waves; ++wave)
    {
      this->UpdateWave(wave, -1);
    }
    for (int wave = waves - 1; wave >= 0; --wave)
    {
      this->UpdateWave(wave, 1);
    }
  }

  static constexpr std::uint8_t Farthest = 128;

private:
  // The rows of one y + 2 z.
  void UpdateWave(int wave, int direction)
  {
    const int first = std::max((wave - this->cellCount.y + 2) / 2, 0);
    const int behind = std::min(wave / 2 + 1, this->cellCount.z);
    constexpr int RowsAtOnce = 8;
    tbb::parallel_for(tbb::blocked_range<int>(first, behind, RowsAtOnce),
      [&](const tbb::blocked_range<int>& planes)
      {
        std::vector<std::uint8_t> nearest(this->cellCount.x);
        for (int z = planes.begin(); z != planes.end(); ++z)
        {
          this->UpdateRow(this->Row(wave - 2 * z, z), direction, nearest.data());
        }
      });
  }

  // Looks at the 13 neighbours that come before a cell in the direction of the pass.
  void UpdateRow(std::uint8_t* cell, int direction, std::uint8_t* nearest) const
  {
    const std::uint8_t* const a = this->Neighbor(cell, direction, 0);
    const std::uint8_t* const b = this->Neighbor(cell, -1, direction);
    const std::uint8_t* const c = this->Neighbor(cell, 0, direction);
    const std::uint8_t* const d = this->Neighbor(cell, 1, direction);
    const int width = this->cellCount.x;
    const int left = IsTowards(this->towards.x, -1) ? -1 : 0;
    const int right = IsTowards(this->towards.x, 1) ? 1 : 0;
    const auto inColumn = [&](int x)
    { return std::min(std::min(a[x], b[x]), std::min(c[x], d[x])); };
    for (int x = 0; x < width; ++x)
    {
      nearest[x] = std::min(std::min(inColumn(x + left), inColumn(x + right)), inColumn(x));
    }
    const int first = direction < 0 ? 0 : width - 1;
    const int perStep = IsTowards(this->towards.x, direction) ? 1 : Farthest;
    int before = Farthest; // what a neighbour outside has
    for (int i = 0; i < width; ++i)
    {
      const int x = first - direction * i;
      before = std::min(int(cell[x]), std::min(int(nearest[x]) + 1, before + perStep));
      cell[x] = std::uint8_t(before);
    }
  }

  static bool IsTowards(int towards, int offset) { return towards * offset >= 0; }

  // A row beside that of a cell, or one outside, where there is nothing.
  const std::uint8_t* Neighbor(const std::uint8_t* cell, int y, int z) const
  {
    return IsTowards(this->towards.y, y) && IsTowards(this->towards.z, z)
      ? cell + y * this->row + z * this->plane
      : &this->distances[1];
  }

  glm::ivec3 cellCount;
  glm::ivec3 towards;
  std::ptrdiff_t row;
  std::ptrdiff_t plane;
  std::vector<std::uint8_t> distances;
};

}

#endif
