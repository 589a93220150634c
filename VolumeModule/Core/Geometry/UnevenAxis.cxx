#include "Core/Geometry/UnevenAxis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

void CheckAscending(const std::vector<double>& points)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if (!(points[i - 1] < points[i]) || !std::isfinite(points[i] - points[i - 1]))
    {
      throw std::invalid_argument("The coordinates of a rectilinear grid must ascend: found " +
        std::to_string(points[i - 1]) + " before " + std::to_string(points[i]));
    }
  }
}

std::vector<double> Middles(const std::vector<double>& points)
{
  std::vector<double> middles;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    middles.push_back(0.5 * (points[i - 1] + points[i]));
  }
  return middles;
}

}

UnevenAxis::UnevenAxis(const std::vector<double>& points, bool ofCells, bool nearest)
{
  CheckAscending(points);
  const bool isThin = points.size() == 1;
  const bool hasMiddles = ofCells && !isThin;
  const std::vector<double> voxels = hasMiddles ? Middles(points) : points;
  const double extent = points.back() - points.front();
  this->voxelCount = int(voxels.size());
  this->firstVoxel = voxels.front();
  this->step = this->voxelCount > 1 ? (voxels.back() - voxels.front()) / (this->voxelCount - 1)
                                    : (isThin ? 1.0 : extent);
  this->lowerGrid = isThin ? -0.5 : this->PlaceGrid(points.front());
  this->upperGrid = isThin ? 0.5 : this->PlaceGrid(points.back());

  // A cell's value reaches to the faces of the cell, not to the middle between two cell centres.
  const bool breaksAtPoints = hasMiddles && nearest;
  this->firstBreakVoxel = breaksAtPoints ? -0.5 : 0.0;
  for (double place : breaksAtPoints ? points : voxels)
  {
    this->breaks.push_back(this->PlaceGrid(place));
  }
  this->smallestGapGrid = this->upperGrid - this->lowerGrid;
  for (std::size_t i = 1; i < this->breaks.size(); ++i)
  {
    this->smallestGapGrid = std::min(this->smallestGapGrid, this->breaks[i] - this->breaks[i - 1]);
  }
  if ((this->upperGrid - this->lowerGrid) / this->smallestGapGrid > MostBins - 2)
  {
    throw std::invalid_argument("The smallest spacing of a rectilinear grid is too small: expected "
                                "at least 1/16384 of the extent of its axis");
  }
}

double UnevenAxis::VoxelAt(double placeGrid) const
{
  const auto above = std::upper_bound(this->breaks.begin(), this->breaks.end(), placeGrid);
  double before = 0.0; // distance to the break above [voxels]
  if (above == this->breaks.end())
  {
    before = 1.0;
  }
  else if (above != this->breaks.begin())
  {
    before = (*above - placeGrid) / (*above - above[-1]);
  }
  const double voxel = this->firstBreakVoxel + double(above - this->breaks.begin()) - before;
  return std::clamp(voxel, 0.0, double(this->voxelCount - 1));
}

std::vector<glm::vec4> UnevenAxis::Bins() const
{
  const double extent = this->upperGrid - this->lowerGrid;
  const int count = int(std::ceil(extent / this->smallestGapGrid)) + 1;
  const auto slopeBefore = [&](std::size_t index)
  { return 1.0 / (this->breaks[index] - this->breaks[index - 1]); };
  std::vector<glm::vec4> bins;
  std::size_t next = 0; // the first break at or behind the bin's lower end
  for (int bin = 0; bin < count; ++bin)
  {
    const double lower = this->lowerGrid + extent * bin / count;
    while (next < this->breaks.size() && this->breaks[next] < lower)
    {
      ++next;
    }
    // Beyond the outermost voxels their values continue, whatever the slope.
    const std::size_t at = std::min(next, this->breaks.size() - 1);
    const double before = at > 0 ? slopeBefore(at) : 1.0;
    const double behind = at + 1 < this->breaks.size() ? slopeBefore(at + 1) : before;
    bins.emplace_back(
      this->breaks[at], this->firstBreakVoxel + double(at), at > 0 ? before : behind, behind);
  }
  return bins;
}

UnevenBins BinsOf(const std::vector<UnevenAxis>& axes)
{
  UnevenBins all;
  for (int axis = 0; axis < int(axes.size()); ++axis)
  {
    const UnevenAxis& uneven = axes[std::size_t(axis)];
    const std::vector<glm::vec4> bins = uneven.Bins();
    all.first[axis] = int(all.bins.size());
    all.bins.insert(all.bins.end(), bins.begin(), bins.end());
    all.last[axis] = int(all.bins.size()) - 1;
    all.lowerGrid[axis] = uneven.LowerGrid();
    all.binsPerGrid[axis] = double(bins.size()) / (uneven.UpperGrid() - uneven.LowerGrid());
  }
  return all;
}

}
