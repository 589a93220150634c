#ifndef Varimarch_Core_Quality_LightSlabs_h
#define Varimarch_Core_Quality_LightSlabs_h

#include "Core/Blocks/BlockLevels.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace varimarch
{

/// Bounds of the extinctions of a part of the volume.
struct Matter
{
  float least = 0.0f;  ///< in either level [1/mm]
  float change = 0.0f; ///< the most by which the levels differ [1/mm]
};

/// Blocks, or columns of rays, in the plane of a slab.
struct Blocks
{
  glm::ivec2 first;
  glm::ivec2 last; ///< included

  bool Contain(const glm::ivec2& one) const
  {
    return one.x >= this->first.x && one.y >= this->first.y && one.x <= this->last.x &&
      one.y <= this->last.y;
  }
};

/// Slabs that follow each other.
struct SlabRange
{
  int first;
  int last; ///< included; less than the first: there are none
};

/// The blocks of a volume in slabs across the axis along which a light shines most, and the columns
/// of rays to it. A column has the numbers of the place where its rays meet slab 0.
class LightSlabs
{
public:
  /// @param blockSideGrid  length of a block's side, in voxels
  /// @param matters      that of each block; kept by reference, as the levels are
  /// @param towardsGrid  unit vector towards the light [grid space per mm]
  LightSlabs(double blockSideGrid, const BlockLevels& levels, const std::vector<Matter>& matters,
    const glm::dvec3& towardsGrid)
    : levels(levels)
    , matters(matters)
  {
    const glm::dvec3 size = glm::abs(towardsGrid);
    this->axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    this->across = { (this->axis + 1) % 3, (this->axis + 2) % 3 };
    this->ascends = towardsGrid[this->axis] > 0.0;
    this->mm = blockSideGrid / size[this->axis];
    for (int i = 0; i < 2; ++i)
    {
      this->shear[i] = towardsGrid[this->across[i]] / size[this->axis];
    }
  }

  int Count() const { return this->levels.count[this->axis]; }
  double Mm() const { return this->mm; }
  glm::ivec2 Across() const
  {
    return { this->levels.count[this->across[0]], this->levels.count[this->across[1]] };
  }
  /// The columns whose rays may be in the volume in a slab.
  Blocks ColumnsIn(int slab) const
  {
    return { this->ColumnsOf(slab, { 0, 0 }).first,
      this->ColumnsOf(slab, this->Across() - 1).last };
  }

  /// All columns.
  Blocks AllColumns() const
  {
    const Blocks near = this->ColumnsIn(0);
    const Blocks far = this->ColumnsIn(this->Count() - 1);
    return { glm::min(near.first, far.first), glm::max(near.last, far.last) };
  }

  /// The slabs in which rays of a column may be in the volume, and perhaps some more.
  SlabRange SlabsOf(const glm::ivec2& column) const
  {
    constexpr double Margin = 2.0; // rays of a column, and their shift in a slab
    SlabRange range{ 0, this->Count() - 1 };
    for (int i = 0; i < 2; ++i)
    {
      const double from = -Margin - double(column[i]);
      const double to = double(this->Across()[i]) + Margin - double(column[i]);
      if (std::abs(this->shear[i]) * double(this->Count()) > 1.0)
      {
        const auto [first, last] = std::minmax({ from / this->shear[i], to / this->shear[i] });
        range.first = std::max(range.first, int(std::floor(std::max(first, 0.0))));
        range.last = int(std::min(double(range.last), std::ceil(last)));
      }
    }
    return range;
  }

  /// Numbers of columns that no two columns of a slab share, less than NumberCount().
  std::size_t NumberOf(const glm::ivec2& column) const
  {
    const glm::ivec2 count = this->NumbersAcross();
    const glm::ivec2 own = (column % count + count) % count;
    return std::size_t(own.y) * std::size_t(count.x) + std::size_t(own.x);
  }
  std::size_t NumberCount() const
  {
    const glm::ivec2 count = this->NumbersAcross();
    return std::size_t(count.x) * std::size_t(count.y);
  }

  /// @param slab  counted towards the light
  std::size_t PlaceOf(int slab, const glm::ivec2& block) const
  {
    return this->levels.PlaceOf(this->BlockAt(slab, block));
  }

  /// The columns whose rays may pass a block.
  Blocks ColumnsOf(int slab, const glm::ivec2& block) const
  {
    const auto [least, most] = this->ShiftsIn(slab);
    return { glm::ivec2(glm::floor(glm::dvec2(block) - most)),
      glm::ivec2(glm::ceil(glm::dvec2(block) + 1.0 - least)) - 1 };
  }

  /// The blocks that rays of a column may pass, inside the volume or not.
  Blocks BlocksOf(int slab, const glm::ivec2& column) const
  {
    const auto [least, most] = this->ShiftsIn(slab);
    return { glm::ivec2(glm::floor(glm::dvec2(column) + least)),
      glm::ivec2(glm::ceil(glm::dvec2(column) + 1.0 + most)) - 1 };
  }

  bool IsInside(const glm::ivec2& block) const
  {
    const glm::ivec2 count = this->Across();
    return block.x >= 0 && block.y >= 0 && block.x < count.x && block.y < count.y;
  }

  /// Calls visit(place) for the blocks of a column in the volume.
  template <class Visit>
  void ForEach(int slab, const glm::ivec2& column, Visit visit) const
  {
    const Blocks blocks = this->BlocksOf(slab, column);
    for (int y = blocks.first.y; y <= blocks.last.y; ++y)
    {
      for (int x = blocks.first.x; x <= blocks.last.x; ++x)
      {
        if (this->IsInside({ x, y }))
        {
          visit(this->PlaceOf(slab, { x, y }));
        }
      }
    }
  }

  /// The matter that rays of a column meet in a slab. The outermost blocks may be cut, so that rays
  /// through them need not meet anything.
  Matter MatterIn(int slab, const glm::ivec2& column) const
  {
    const Blocks blocks = this->BlocksOf(slab, column);
    const bool isWhole = slab > 0 && slab + 1 < this->Count() && this->IsInner(blocks.first) &&
      this->IsInner(blocks.last);
    Matter all{ isWhole ? std::numeric_limits<float>::max() : 0.0f, 0.0f };
    this->ForEach(slab, column,
      [&](std::size_t place)
      {
        const Matter& own = this->matters[place];
        all = { std::min(all.least, own.least), std::max(all.change, own.change) };
      });
    return all;
  }

private:
  // Rays are shifted by at most a block in a slab.
  glm::ivec2 NumbersAcross() const { return this->Across() + 4; }

  glm::ivec3 BlockAt(int slab, const glm::ivec2& block) const
  {
    glm::ivec3 at;
    at[this->axis] = this->ascends ? slab : this->Count() - 1 - slab;
    at[this->across[0]] = block.x;
    at[this->across[1]] = block.y;
    return at;
  }

  bool IsInner(const glm::ivec2& block) const
  {
    const glm::ivec2 count = this->Across();
    return block.x > 0 && block.y > 0 && block.x + 1 < count.x && block.y + 1 < count.y;
  }

  // How far rays are shifted in a slab from where they are counted.
  std::pair<glm::dvec2, glm::dvec2> ShiftsIn(int slab) const
  {
    const glm::dvec2 begin = double(slab) * this->shear;
    const glm::dvec2 end = begin + this->shear;
    return { glm::min(begin, end), glm::max(begin, end) };
  }

  const BlockLevels& levels;
  const std::vector<Matter>& matters;
  int axis;
  glm::ivec2 across; ///< the other axes
  bool ascends;      ///< true if the light is where the axis ascends
  double mm;         ///< length of a ray in a slab
  glm::dvec2 shear;  ///< blocks per slab, at most 1
};

}

#endif
