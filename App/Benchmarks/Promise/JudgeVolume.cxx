#include "JudgeScene.h"

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

double JudgeCrossing(const JudgeCubic& cubic, double value, double from, double to)
{
  const bool rises = ValueOf(cubic, from) < ValueOf(cubic, to);
  double u = 0.5 * (from + to);
  // Newton's method in a bracket; halving where a step would leave it.
  for (int i = 0; i < 60 && to - from > 1e-15; ++i)
  {
    const double off = ValueOf(cubic, u) - value;
    ((off < 0.0) == rises ? from : to) = u;
    const double slope = (3.0 * cubic[3] * u + 2.0 * cubic[2]) * u + cubic[1];
    const double next = u - off / slope;
    if (!(from < next && next < to))
    {
      u = 0.5 * (from + to);
      continue;
    }
    if (std::abs(next - u) < 1e-15)
    {
      return next;
    }
    u = next;
  }
  return u;
}

std::vector<double> JudgeTurns(const JudgeCubic& cubic)
{
  std::vector<double> turns = { 0.0 };
  const auto add = [&](double u)
  {
    if (turns.back() < u && u < 1.0)
    {
      turns.push_back(u);
    }
  };
  // The roots of 3 c3 u^2 + 2 c2 u + c1, by the formula that cancels nothing.
  const double a = 3.0 * cubic[3];
  const double half = cubic[2];
  const double discriminant = half * half - a * cubic[1];
  if (discriminant >= 0.0)
  {
    const double q = -(half + std::copysign(std::sqrt(discriminant), half));
    const double one = a != 0.0 ? q / a : -1.0;
    const double other = q != 0.0 ? cubic[1] / q : -1.0;
    add(std::min(one, other));
    add(std::max(one, other));
  }
  turns.push_back(1.0);
  return turns;
}

namespace
{

// Trilinear interpolation of eight corners along a line from `e`, by `w`, both in the cell.
JudgeCubic CubicOf(const std::array<double, 8>& v, glm::dvec3 e, glm::dvec3 w)
{
  const double x = v[1] - v[0];
  const double y = v[2] - v[0];
  const double z = v[4] - v[0];
  const double xy = v[3] - v[1] - y;
  const double yz = v[6] - v[4] - y;
  const double zx = v[5] - v[4] - x;
  const double xyz = (v[7] - v[5]) - (v[6] - v[4]) - xy;
  const double whole = v[0] + x * e.x + y * e.y + z * e.z + xy * e.x * e.y + yz * e.y * e.z +
    zx * e.z * e.x + xyz * e.x * e.y * e.z;
  return { whole,
    x * w.x + y * w.y + z * w.z + xy * (e.x * w.y + e.y * w.x) + yz * (e.y * w.z + e.z * w.y) +
      zx * (e.z * w.x + e.x * w.z) + xyz * (w.x * e.y * e.z + e.x * w.y * e.z + e.x * e.y * w.z),
    xy * w.x * w.y + yz * w.y * w.z + zx * w.z * w.x +
      xyz * (w.x * w.y * e.z + w.x * e.y * w.z + e.x * w.y * w.z),
    xyz * w.x * w.y * w.z };
}

glm::ivec3 Corner(int number)
{
  return { number & 1, number >> 1 & 1, number >> 2 };
}

}

void JudgeVolume::Fill(const JudgeRay& rayGrid, JudgeSpan& span) const
{
  if (this->isNearest)
  {
    span.value = { this->Voxel(span.cell) };
    const glm::dvec3 gradient =
      this->gradients.empty() ? glm::dvec3(0.0) : this->Gradient(span.cell);
    span.gradient = { JudgeCubic{ gradient.x }, JudgeCubic{ gradient.y },
      JudgeCubic{ gradient.z } };
    return;
  }
  const glm::dvec3 enter = rayGrid.At(span.enter) - glm::dvec3(span.cell);
  const glm::dvec3 way = (span.exit - span.enter) * rayGrid.direction;
  std::array<double, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[std::size_t(i)] = this->Voxel(span.cell + Corner(i));
  }
  span.value = CubicOf(corners, enter, way);
  for (int axis = 0; axis < 3 && !this->gradients.empty(); ++axis)
  {
    for (int i = 0; i < 8; ++i)
    {
      corners[std::size_t(i)] = this->Gradient(span.cell + Corner(i))[axis];
    }
    span.gradient[std::size_t(axis)] = CubicOf(corners, enter, way);
  }
}

glm::dvec3 JudgeVolume::GradientAt(const JudgeSpan& span, double u) const
{
  return { ValueOf(span.gradient[0], u), ValueOf(span.gradient[1], u),
    ValueOf(span.gradient[2], u) };
}

double JudgeVolume::MagnitudeOf(glm::dvec3 gradient) const
{
  return glm::length(this->magnitudeFactors * gradient);
}

double JudgeVolume::ExtinctionAt(const JudgeSpan& span, const JudgeLook::Band& band, double u) const
{
  const JudgeLook& look = this->looks[std::size_t(span.look)];
  double opacity = look.Opacity(band, ValueOf(span.value, u));
  if (look.HasGradientOpacity() && opacity > 0.0)
  {
    const double saturated = 0.25 * (this->mostValue - this->leastValue); // as in VTK
    opacity *=
      look.GradientFactor(std::min(this->MagnitudeOf(this->GradientAt(span, u)), saturated));
  }
  return look.Extinction(opacity, this->mostExtinction);
}

namespace
{

// The places at which the magnitude of the gradient passes a node of its opacity.
void AddGradientCuts(const JudgeVolume& volume, const JudgeSpan& span, std::vector<double>& cuts)
{
  constexpr int Parts = 16;
  const JudgeLook& look = volume.looks[std::size_t(span.look)];
  const auto magnitude = [&](double u) { return volume.MagnitudeOf(volume.GradientAt(span, u)); };
  for (int i = 0; i < Parts; ++i)
  {
    const double ends[2] = { double(i) / Parts, double(i + 1) / Parts };
    const double values[2] = { magnitude(ends[0]), magnitude(ends[1]) };
    for (const double node : look.GradientNodes())
    {
      if ((values[0] < node) == (values[1] < node))
      {
        continue;
      }
      double from = ends[0];
      double to = ends[1];
      for (int k = 0; k < 45; ++k)
      {
        const double middle = 0.5 * (from + to);
        ((magnitude(middle) < node) == (values[0] < node) ? from : to) = middle;
      }
      cuts.push_back(0.5 * (from + to));
    }
  }
}

// True if a polynomial certainly stays within one band.
bool StaysInBand(const JudgeLook& look, const JudgeCubic& cubic)
{
  const double most = std::abs(cubic[1]) + std::abs(cubic[2]) + std::abs(cubic[3]);
  return look.BandOf(cubic[0] - most) == look.BandOf(cubic[0] + most);
}

}

void JudgeVolume::FindPieces(const JudgeSpan& span, std::vector<JudgePiece>& pieces) const
{
  const JudgeLook& look = this->looks[std::size_t(span.look)];
  thread_local std::vector<double> cuts;
  cuts.assign({ 0.0, 1.0 });
  if (!this->isNearest && !StaysInBand(look, span.value))
  {
    const std::vector<double> turns = JudgeTurns(span.value);
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
    {
      cuts.push_back(turns[i]);
      const double ends[2] = { ValueOf(span.value, turns[i]), ValueOf(span.value, turns[i + 1]) };
      const int last = look.BandOf(std::max(ends[0], ends[1]));
      for (int band = look.BandOf(std::min(ends[0], ends[1])); band < last; ++band)
      {
        cuts.push_back(JudgeCrossing(span.value, look[band].upper, turns[i], turns[i + 1]));
      }
    }
  }
  if (look.HasGradientOpacity() && !this->isNearest)
  {
    AddGradientCuts(*this, span, cuts);
  }
  std::sort(cuts.begin(), cuts.end());
  pieces.clear();
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const double middle = ValueOf(span.value, 0.5 * (cuts[i] + cuts[i + 1]));
    const JudgeLook::Band& band = look[look.BandOf(middle)];
    if (cuts[i] < cuts[i + 1] && !band.isInvisible)
    {
      pieces.push_back({ cuts[i], cuts[i + 1], &band });
    }
  }
}

}
