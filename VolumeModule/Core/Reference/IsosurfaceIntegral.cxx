#include "Core/Reference/IsosurfaceIntegral.h"

#include "Core/Reference/CellPieces.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Accumulates the surfaces that a ray passes.
class SurfaceSum
{
public:
  SurfaceSum(const ReferenceScene& scene, const MeasuredRay& ray)
    : scene(scene)
    , ray(ray)
  {
  }

  /// @return true if what is behind the cell can be seen
  bool AddCell(const CellPart& part, const CellCorners& corners);

  glm::dvec4 Color() const { return { this->rgb, 1.0 - this->transmittance }; }

private:
  void AddMonotone(const CellPart& part, const CellCubic& cubic, double from, double to);
  void AddSurface(const CellPart& part, double value, double u);

  const ReferenceScene& scene;
  const MeasuredRay& ray;
  glm::dvec3 rgb = glm::dvec3(0.0);
  double transmittance = 1.0;

  /// Exit of the previous cell [ray parameter].
  double lastExit = std::numeric_limits<double>::quiet_NaN();
  double lastValue = 0.0; ///< value at that exit
};

bool SurfaceSum::AddCell(const CellPart& part, const CellCorners& corners)
{
  // Rounding makes the two cells at a face disagree about the value there. If each used its own, a
  // ray might miss a surface at the face, or pass it twice.
  CellPiece piece = PieceOf(part, corners, this->ray.grid);
  if (part.t.enter == this->lastExit)
  {
    piece.cubic = piece.cubic.StartingAt(this->lastValue);
  }
  this->lastExit = part.t.exit;
  this->lastValue = piece.cubic.Value(1.0);

  const CellCubic::Cuts cuts = piece.cubic.MonotoneCuts();
  for (int i = 0; i + 1 < cuts.count; ++i)
  {
    this->AddMonotone(part, piece.cubic, cuts.u[i], cuts.u[i + 1]);
  }
  return this->transmittance > 0.0;
}

void SurfaceSum::AddMonotone(const CellPart& part, const CellCubic& cubic, double from, double to)
{
  const double first = cubic.Value(from);
  const double last = cubic.Value(to);
  // The ray passes the isovalues above the smaller end, up to and including the larger.
  const std::vector<double>& values = this->scene.isovalues;
  const auto begin = std::upper_bound(values.begin(), values.end(), std::min(first, last));
  const auto end = std::upper_bound(begin, values.end(), std::max(first, last));
  std::vector<double> passed(begin, end);
  if (first > last)
  {
    std::reverse(passed.begin(), passed.end());
  }
  for (const double value : passed)
  {
    this->AddSurface(part, value, cubic.Crossing(value, from, to));
  }
}

void SurfaceSum::AddSurface(const CellPart& part, double value, double u)
{
  const double opacity = this->scene.transferFunction.Opacity(value);
  const glm::dvec3 color = this->scene.transferFunction.Color(value);
  const glm::dvec3 lit =
    this->scene.shade ? this->scene.shade(part, this->ray.grid).emitted(color, u) : color;
  this->rgb += this->transmittance * opacity * lit;
  this->transmittance *= 1.0 - opacity;
}

}

IsosurfaceIntegral::IsosurfaceIntegral(ReferenceScene givenScene)
  : scene(std::move(givenScene))
{
  std::vector<double>& values = this->scene.isovalues;
  const auto isNotFinite = [](double value) { return !std::isfinite(value); };
  values.erase(std::remove_if(values.begin(), values.end(), isNotFinite), values.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

ReferenceColor IsosurfaceIntegral::Along(const MeasuredRay& ray) const
{
  SurfaceSum sum(this->scene, ray);
  WalkFiniteCells(this->scene, ray,
    [&](const CellPart& part, const CellCorners& corners) { return sum.AddCell(part, corners); });
  return { sum.Color(), 0.0 };
}

}
