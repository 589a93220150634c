#include "JudgeVolume.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

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
