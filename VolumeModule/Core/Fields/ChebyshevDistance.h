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

/// Chebyshev distance of each cell of a lattice to a set of cells, by the two passes of Rosenfeld
/// and Pfaltz (Pattern Recognition 1968) over the 26 neighbours, which are exact for this metric.
///
/// The distance can be limited to cells that lie in given directions; the passes then ignore
/// neighbours that lie behind. It remains exact, because a distance is the length of a path over
/// neighbours whose steps may be taken in any order.
///
/// No cell outside the lattice is in the set. A row depends only on the rows before it in its plane
/// and in the plane before, so that all rows with the same y + 2 z are measured in parallel.
class ChebyshevDistance
{
public:
  /// @param towards  direction along each axis: 1, -1, or 0 for both
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

  /// Before the call, rows hold 0 for cells in the set and Farthest for others. Afterwards they
  /// hold the distance of each cell: 1 next to the set, and at most Farthest.
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
  // Updates all rows with the same y + 2 z.
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

  // Uses the 13 neighbours that precede a cell in the direction of the pass.
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
    int before = Farthest; // the distance of a neighbour outside the lattice
    for (int i = 0; i < width; ++i)
    {
      const int x = first - direction * i;
      before = std::min(int(cell[x]), std::min(int(nearest[x]) + 1, before + perStep));
      cell[x] = std::uint8_t(before);
    }
  }

  static bool IsTowards(int towards, int offset) { return towards * offset >= 0; }

  // The row next to a cell's row, or an outside row that has no distances.
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
