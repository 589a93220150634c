#include "Scene/VolumeWriters/ZarrLevels.h"

#include <vtkSetGet.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

/// A fine block, and the groups of its voxels.
template <class Number>
struct FineVoxels
{
  const Number* values;
  ZarrIndex size;
  ZarrIndex factors;
  int componentCount;

  const Number& At(const ZarrIndex& at, int component) const
  {
    const std::int64_t voxel = (at[2] * this->size[1] + at[1]) * this->size[0] + at[0];
    return this->values[voxel * this->componentCount + component];
  }

  /// The mean of a group, rounded for whole numbers. Groups at the end may be cut.
  Number MeanAt(const ZarrIndex& first, int component) const
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t k = first[2]; k < std::min(this->size[2], first[2] + this->factors[2]); ++k)
    {
      for (std::int64_t j = first[1]; j < std::min(this->size[1], first[1] + this->factors[1]); ++j)
      {
        for (std::int64_t i = first[0]; i < std::min(this->size[0], first[0] + this->factors[0]);
             ++i, ++count)
        {
          sum += double(this->At({ i, j, k }, component));
        }
      }
    }
    const double mean = sum / count;
    return Number(std::numeric_limits<Number>::is_integer ? std::floor(mean + 0.5) : mean);
  }
};

template <class Number>
void PutNumbers(
  const FineVoxels<Number>& fine, const ZarrIndex& place, bool isLabels, ZarrBlock& block)
{
  auto* const coarse = reinterpret_cast<Number*>(block.voxels.data());
  ZarrIndex size;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = (fine.size[axis] + fine.factors[axis] - 1) / fine.factors[axis];
  }
  for (std::int64_t k = 0; k < size[2]; ++k)
  {
    for (std::int64_t j = 0; j < size[1]; ++j)
    {
      const std::int64_t row =
        ((place[2] + k) * block.size[1] + place[1] + j) * block.size[0] + place[0];
      for (std::int64_t i = 0; i < size[0]; ++i)
      {
        const ZarrIndex first = { i * fine.factors[0], j * fine.factors[1], k * fine.factors[2] };
        for (int component = 0; component < fine.componentCount; ++component)
        {
          coarse[(row + i) * fine.componentCount + component] =
            isLabels ? fine.At(first, component) : fine.MeanAt(first, component);
        }
      }
    }
  }
}

}

std::vector<ZarrLevel> ZarrLevelsOf(const ZarrIndex& dimensions)
{
  std::vector<ZarrLevel> levels = { { dimensions, { 1, 1, 1 } } };
  while (*std::max_element(levels.back().dimensions.begin(), levels.back().dimensions.end()) >
    ZarrChunkSide)
  {
    ZarrLevel next = { levels.back().dimensions, { 1, 1, 1 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      next.factors[axis] = next.dimensions[axis] > ZarrChunkSide ? 2 : 1;
      next.dimensions[axis] = (next.dimensions[axis] + next.factors[axis] - 1) / next.factors[axis];
    }
    levels.push_back(next);
  }
  return levels;
}

std::int64_t ZarrChunkCount(std::int64_t voxels)
{
  return (voxels + ZarrChunkSide - 1) / ZarrChunkSide;
}

void PutCoarse(const ZarrInput& input, const ZarrBlock& child, const ZarrIndex& factors,
  const ZarrIndex& place, ZarrBlock& block)
{
  switch (input.scalarType)
  {
    vtkTemplateMacro(PutNumbers<VTK_TT>({ reinterpret_cast<const VTK_TT*>(child.voxels.data()),
                                          child.size, factors, input.componentCount },
      place, input.isLabels, block));
  }
}

}
