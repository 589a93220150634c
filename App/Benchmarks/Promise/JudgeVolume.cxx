#include "JudgeVolume.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

glm::dvec3 Moved(const glm::dmat4& matrix, glm::dvec3 position)
{
  return glm::dvec3(matrix * glm::dvec4(position, 1.0));
}

}

std::size_t JudgeVolume::IndexOf(glm::ivec3 index) const
{
  index = glm::clamp(index, glm::ivec3(0), this->size - 1);
  return (std::size_t(index.z) * this->size.y + index.y) * this->size.x + index.x;
}

double JudgeVolume::Voxel(glm::ivec3 index) const
{
  return this->voxels[this->IndexOf(index)];
}

glm::dvec3 JudgeVolume::Gradient(glm::ivec3 index) const
{
  return this->gradients[this->IndexOf(index)];
}

bool JudgeVolume::MayBeVisible(glm::ivec3 cell) const
{
  double least = Infinite;
  double most = -Infinite;
  for (int corner = 0; corner < (this->isNearest ? 1 : 8); ++corner)
  {
    const double value = this->Voxel(cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2));
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return std::any_of(this->looks.begin(), this->looks.end(),
    [&](const JudgeLook& look) { return look.MayBeVisible(least, most); });
}

void JudgeVolume::Prepare(bool needsGradients)
{
  this->gridFromWorld = glm::inverse(this->worldFromGrid);
  const glm::dmat3 axes(this->worldFromGrid);
  this->smallestSpacingMm =
    std::min({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
  const glm::dvec3 extent = this->boxUpper - this->boxLower;
  this->diagonalMm = 0.0;
  for (const glm::dvec3 signs :
    { glm::dvec3(1, 1, 1), glm::dvec3(1, 1, -1), glm::dvec3(1, -1, 1), glm::dvec3(1, -1, -1) })
  {
    this->diagonalMm = std::max(this->diagonalMm, glm::length(axes * (extent * signs)));
  }
  const auto [least, most] = std::minmax_element(this->voxels.begin(), this->voxels.end());
  this->leastValue = *least;
  this->mostValue = *most;
  constexpr double MostPerVoxel = 3e4;
  this->mostExtinction = MostPerVoxel / this->smallestSpacingMm;
  for (std::size_t i = 0; i < this->voxels.size(); ++i)
  {
    const glm::ivec3 voxel(int(i) % this->size.x, int(i) / this->size.x % this->size.y,
      int(i) / this->size.x / this->size.y);
    this->cellIsVisible.push_back(this->MayBeVisible(voxel));
    const auto beside = [&](int axis)
    {
      glm::ivec3 offset(0);
      offset[axis] = 1;
      return 0.5 * (this->Voxel(voxel + offset) - this->Voxel(voxel - offset));
    };
    if (needsGradients)
    {
      this->gradients.emplace_back(beside(0), beside(1), beside(2));
    }
  }
}

bool JudgeVolume::IsLeft(glm::dvec3 world) const
{
  for (const glm::dvec4& plane : this->clippingPlanes)
  {
    if (glm::dot(plane, glm::dvec4(world, 1.0)) < 0.0)
    {
      return false;
    }
  }
  if (!this->isCropped)
  {
    return true;
  }
  const glm::dvec3 data = Moved(this->dataFromGrid, Moved(this->gridFromWorld, world));
  int region = 0;
  int weight = 1;
  for (int axis = 0; axis < 3; ++axis, weight *= 3)
  {
    region += weight *
      ((data[axis] >= this->croppingPlanes[2 * axis]) +
        (data[axis] >= this->croppingPlanes[2 * axis + 1]));
  }
  return (this->croppingFlags >> region & 1) != 0;
}

std::array<double, 2> JudgeVolume::PartInBox(const JudgeRay& rayGrid, double from, double to) const
{
  const glm::dvec3 origin = rayGrid.origin;
  const glm::dvec3 direction = rayGrid.direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double one = (this->boxLower[axis] - origin[axis]) / direction[axis];
    const double other = (this->boxUpper[axis] - origin[axis]) / direction[axis];
    const bool isInside =
      this->boxLower[axis] <= origin[axis] && origin[axis] <= this->boxUpper[axis];
    const bool isParallel = direction[axis] == 0.0;
    from = isParallel ? (isInside ? from : Infinite) : std::max(from, std::min(one, other));
    to = isParallel ? to : std::min(to, std::max(one, other));
  }
  return { from, to };
}

std::vector<std::array<double, 2>> JudgeVolume::PartsLeft(
  const JudgeRay& ray, double from, double to) const
{
  const glm::dvec3 origin = Moved(this->gridFromWorld, ray.origin);
  const glm::dvec3 direction = glm::dmat3(this->gridFromWorld) * ray.direction;
  const std::array<double, 2> inside = this->PartInBox({ origin, direction }, from, to);
  if (!(inside[0] < inside[1]))
  {
    return {};
  }
  std::vector<double> cuts = { inside[0], inside[1] };
  const auto addRoot = [&](double atOrigin, double slope)
  {
    const double t = -atOrigin / slope;
    if (inside[0] < t && t < inside[1])
    {
      cuts.push_back(t);
    }
  };
  for (const glm::dvec4& plane : this->clippingPlanes)
  {
    addRoot(glm::dot(plane, glm::dvec4(ray.origin, 1.0)),
      glm::dot(plane, glm::dvec4(ray.direction, 0.0)));
  }
  for (int i = 0; i < 6 && this->isCropped; ++i)
  {
    addRoot(Moved(this->dataFromGrid, origin)[i / 2] - this->croppingPlanes[std::size_t(i)],
      (glm::dmat3(this->dataFromGrid) * direction)[i / 2]);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::array<double, 2>> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    if (cuts[i] < cuts[i + 1] && this->IsLeft(ray.At(0.5 * (cuts[i] + cuts[i + 1]))))
    {
      parts.push_back({ cuts[i], cuts[i + 1] });
    }
  }
  return parts;
}

void JudgeVolume::WalkVisible(const JudgeRay& ray, double from, double to,
  const std::function<bool(const JudgeSpan&)>& visit) const
{
  this->Walk(ray, from, to, true, visit);
}

void JudgeVolume::WalkAll(const JudgeRay& ray, double from, double to,
  const std::function<bool(const JudgeSpan&)>& visit) const
{
  this->Walk(ray, from, to, false, visit);
}

void JudgeVolume::Walk(const JudgeRay& ray, double from, double to, bool onlyVisible,
  const std::function<bool(const JudgeSpan&)>& visit) const
{
  for (const std::array<double, 2>& part : this->PartsLeft(ray, from, to))
  {
    if (!this->WalkCells(ray, part, onlyVisible, visit))
    {
      return;
    }
  }
}

// From cell to cell; each face's place is computed from scratch. Without interpolation cells are
// the boxes around voxels.
bool JudgeVolume::WalkCells(const JudgeRay& ray, std::array<double, 2> part, bool onlyVisible,
  const std::function<bool(const JudgeSpan&)>& visit) const
{
  const double shift = this->isNearest ? 0.5 : 0.0;
  const JudgeRay grid{ Moved(this->gridFromWorld, ray.origin),
    glm::dmat3(this->gridFromWorld) * ray.direction };
  const glm::ivec3 last = this->isNearest ? this->size - 1 : glm::max(this->size - 2, 0);
  const glm::ivec3 first =
    glm::clamp(glm::ivec3(glm::floor(grid.At(part[0]) + shift)), glm::ivec3(0), last);
  glm::ivec3 cell = first;
  double enter = part[0];
  while (enter < part[1])
  {
    double exit = part[1];
    int through = -1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool rises = grid.direction[axis] > 0.0;
      const double face = cell[axis] + (rises ? 1 : 0) - shift;
      const double t =
        grid.direction[axis] != 0.0 ? (face - grid.origin[axis]) / grid.direction[axis] : Infinite;
      const bool isWithin = rises ? cell[axis] < last[axis] : cell[axis] > 0;
      if (isWithin && t < exit)
      {
        exit = t;
        through = axis;
      }
    }
    const bool isSeen = !onlyVisible || this->cellIsVisible[this->IndexOf(cell)] != 0;
    if (enter < exit && isSeen && !this->VisitCell(grid, cell, { enter, exit }, visit))
    {
      return false;
    }
    enter = std::max(enter, exit);
    if (through < 0)
    {
      break;
    }
    cell[through] += grid.direction[through] > 0.0 ? 1 : -1;
  }
  return true;
}

// Cuts the part of a ray in a cell where it goes from the box of one voxel to the next, if a mask
// tells them apart.
bool JudgeVolume::VisitCell(const JudgeRay& rayGrid, glm::ivec3 cell, std::array<double, 2> part,
  const std::function<bool(const JudgeSpan&)>& visit) const
{
  if (this->lookOfVoxel.empty())
  {
    JudgeSpan span{ part[0], part[1], cell, 0, {}, {} };
    this->Fill(rayGrid, span);
    return visit(span);
  }
  std::vector<double> cuts = { part[0], part[1] };
  for (int axis = 0; axis < 3 && !this->isNearest; ++axis)
  {
    const double t = (cell[axis] + 0.5 - rayGrid.origin[axis]) / rayGrid.direction[axis];
    if (part[0] < t && t < part[1])
    {
      cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const glm::dvec3 middle = rayGrid.At(0.5 * (cuts[i] + cuts[i + 1]));
    const glm::ivec3 voxel = this->isNearest ? cell : glm::ivec3(glm::floor(middle + 0.5));
    JudgeSpan span{ cuts[i], cuts[i + 1], cell, this->lookOfVoxel[this->IndexOf(voxel)], {}, {} };
    if (span.look >= 0 && span.enter < span.exit)
    {
      this->Fill(rayGrid, span);
      if (!visit(span))
      {
        return false;
      }
    }
  }
  return true;
}

}
