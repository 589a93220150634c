#include "Core/Look/PreIntegratedTable.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Sums over the intervals up to an entry of a table. Opaque intervals are summed separately,
/// because next to their extinction that of all others would be lost to rounding.
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
Prefix SumsOfInterval(const glm::vec4& first, const glm::vec4& last)
{
  const glm::dvec4 a(first);
  const glm::dvec4 b(last);
  const glm::dvec3 colorA(a);
  const glm::dvec3 colorB(b);
  if (std::max(a.a, b.a) >= double(OpaqueExtinction))
  {
    return { 0.0, glm::dvec3(0.0), 1.0, a.a >= b.a ? colorA : colorB };
  }
  const glm::dvec3 emission = (colorA * (2.0 * a.a + b.a) + colorB * (a.a + 2.0 * b.a)) / 6.0;
  return { 0.5 * (a.a + b.a), emission, 0.0, glm::dvec3(0.0) };
}

/// The sums up to, and the entries at, `size` equidistant positions in a table.
struct Nodes
{
  std::vector<Prefix> sums;
  std::vector<glm::vec4> entries;
};

Nodes NodesOf(const OpticalTable& table, int size)
{
  Nodes nodes;
  const double entriesPerNode = double(table.entries.size() - 1) / (size - 1);
  const std::size_t lastInterval = table.entries.size() - 2;
  Prefix sum;
  std::size_t interval = 0;
  for (int node = 0; node < size; ++node)
  {
    const double position = node * entriesPerNode;
    for (; interval < std::min(std::size_t(position), lastInterval); ++interval)
    {
      sum = sum.Plus(SumsOfInterval(table.entries[interval], table.entries[interval + 1]), 1.0);
    }
    const double part = position - double(interval);
    const glm::vec4 entry =
      glm::mix(table.entries[interval], table.entries[interval + 1], float(part));
    nodes.sums.push_back(sum.Plus(SumsOfInterval(table.entries[interval], entry), part));
    nodes.entries.push_back(entry);
  }
  return nodes;
}

/// The means between two nodes.
/// @param length  distance of the nodes, in entries of the optical table
glm::vec4 Mean(const Prefix& before, const Prefix& after, double length)
{
  const Prefix sum = after.Plus(before, -1.0);
  if (sum.opaqueLength > 1e-9 * length)
  {
    const double extinction = double(OpaqueExtinction) * std::min(sum.opaqueLength / length, 1.0);
    return glm::vec4(extinction * sum.opaqueColor / sum.opaqueLength, extinction);
  }
  const double extinction = std::max(sum.extinction, 0.0);
  const glm::dvec3 color =
    extinction > 0.0 ? glm::clamp(sum.emission / extinction, 0.0, 1.0) : glm::dvec3(0.0);
  return glm::vec4(color, 1.0) * float(extinction / length);
}

glm::vec4 Emitted(const glm::vec4& entry)
{
  return glm::vec4(glm::vec3(entry) * entry.a, entry.a);
}

int SizeFor(const OpticalTable& table, std::size_t mostEntries)
{
  return int(std::min(std::sqrt(double(mostEntries)), double(table.entries.size())));
}

}

std::size_t PreIntegratedTableBytes(const OpticalTable& table, std::size_t mostEntries)
{
  const std::size_t size = SizeFor(table, mostEntries);
  return size * size * sizeof(glm::vec4);
}

PreIntegratedTable BuildPreIntegratedTable(const OpticalTable& table, std::size_t mostEntries)
{
  const int size = SizeFor(table, mostEntries);
  const Nodes nodes = NodesOf(table, size);
  const double entriesPerNode = double(table.entries.size() - 1) / (size - 1);
  PreIntegratedTable result{ table.firstValue, table.lastValue, size,
    std::vector<glm::vec4>(std::size_t(size) * size) };
  tbb::parallel_for(tbb::blocked_range<int>(0, size, 16),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column <= row; ++column)
        {
          const glm::vec4 mean = column == row
            ? Emitted(nodes.entries[row])
            : Mean(nodes.sums[column], nodes.sums[row], (row - column) * entriesPerNode);
          result.entries[std::size_t(row) * size + column] = mean;
          result.entries[std::size_t(column) * size + row] = mean;
        }
      }
    });
  return result;
}

}
