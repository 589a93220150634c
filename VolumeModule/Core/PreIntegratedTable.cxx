#include "Core/PreIntegratedTable.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Sums over the intervals between the first entries of a table. Opaque intervals are summed apart:
/// beside their extinction that of all others would be lost to rounding.
struct Prefix
{
  double extinction = 0.0;
  glm::dvec3 emission = glm::dvec3(0.0); ///< extinction times colour
  double opaqueLength = 0.0;
  glm::dvec3 opaqueColor = glm::dvec3(0.0);

  Prefix Plus(const Prefix& other, double factor) const
  {
    return { this->extinction + factor * other.extinction, this->emission + factor * other.emission,
      this->opaqueLength + factor * other.opaqueLength,
      this->opaqueColor + factor * other.opaqueColor };
  }
};

/// The sums over one interval, in which colour and extinction are linear.
Prefix OfInterval(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec3 colorA(a);
  const glm::dvec3 colorB(b);
  if (std::max(a.a, b.a) >= double(OpaqueExtinction))
  {
    return { 0.0, glm::dvec3(0.0), 1.0, a.a >= b.a ? colorA : colorB };
  }
  const glm::dvec3 emission = (colorA * (2.0 * a.a + b.a) + colorB * (a.a + 2.0 * b.a)) / 6.0;
  return { 0.5 * (a.a + b.a), emission, 0.0, glm::dvec3(0.0) };
}

class TableIntegral
{
public:
  explicit TableIntegral(const OpticalTable& table)
    : table(table)
    , prefix(table.entries.size())
  {
    for (std::size_t i = 1; i < this->prefix.size(); ++i)
    {
      this->prefix[i] = this->prefix[i - 1].Plus(
        OfInterval(glm::dvec4(table.entries[i - 1]), glm::dvec4(table.entries[i])), 1.0);
    }
  }

  double LastPosition() const { return double(this->prefix.size() - 1); }

  /// The means between two positions, counted in entries.
  glm::vec4 Mean(double from, double to) const
  {
    if (from == to)
    {
      const std::size_t below = this->Below(from);
      return glm::mix(
        this->table.entries[below], this->table.entries[below + 1], float(from - double(below)));
    }
    const Prefix sum = this->Until(std::max(from, to)).Plus(this->Until(std::min(from, to)), -1.0);
    const double length = std::abs(to - from);
    if (sum.opaqueLength > 1e-9 * length)
    {
      return glm::vec4(sum.opaqueColor / sum.opaqueLength,
        std::min(double(OpaqueExtinction) * sum.opaqueLength / length, double(OpaqueExtinction)));
    }
    const double extinction = std::max(sum.extinction, 0.0);
    const glm::dvec3 color =
      extinction > 0.0 ? glm::clamp(sum.emission / extinction, 0.0, 1.0) : glm::dvec3(0.0);
    return glm::vec4(color, extinction / length);
  }

private:
  std::size_t Below(double position) const
  {
    return std::min(std::size_t(position), this->prefix.size() - 2);
  }

  Prefix Until(double position) const
  {
    const std::size_t below = this->Below(position);
    const double part = position - double(below);
    const glm::dvec4 a(this->table.entries[below]);
    const glm::dvec4 b(this->table.entries[below + 1]);
    return this->prefix[below].Plus(OfInterval(a, glm::mix(a, b, part)), part);
  }

  const OpticalTable& table;
  std::vector<Prefix> prefix; ///< over all intervals before an entry
};

}

PreIntegratedTable BuildPreIntegratedTable(const OpticalTable& table, std::size_t mostEntries)
{
  const TableIntegral integral(table);
  const int size = int(std::min(table.entries.size(), std::size_t(std::sqrt(double(mostEntries)))));
  PreIntegratedTable result{ table.firstValue, table.lastValue, size,
    std::vector<glm::vec4>(std::size_t(size) * size) };
  const double positionPerIndex = integral.LastPosition() / (size - 1);
  tbb::parallel_for(tbb::blocked_range<int>(0, size, 16),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column < size; ++column)
        {
          result.entries[std::size_t(row) * size + column] =
            integral.Mean(row * positionPerIndex, column * positionPerIndex);
        }
      }
    });
  return result;
}

}
