#include "Core/Reference/ExtremeIntegral.h"

#include "Core/Reference/CellPieces.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

ExtremeIntegral::ExtremeIntegral(ReferenceScene scene, Extreme extreme)
  : scene(std::move(scene))
  , sign(extreme == Extreme::Largest ? 1.0 : -1.0)
{
}

ReferenceColor ExtremeIntegral::Along(const MeasuredRay& ray) const
{
  double extreme = -std::numeric_limits<double>::infinity();
  WalkFiniteCells(this->scene, ray,
    [&](const CellPart& part, const CellCorners& corners)
    {
      const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end());
      if (std::max(this->sign * *lowest, this->sign * *highest) > extreme)
      {
        const CellCubic cubic = PieceOf(part, corners, ray.grid).cubic;
        const CellCubic::Cuts cuts = cubic.MonotoneCuts();
        for (int i = 0; i < cuts.count; ++i)
        {
          extreme = std::max(extreme, this->sign * cubic.Value(cuts.u[i]));
        }
      }
      return true;
    });
  if (!std::isfinite(extreme))
  {
    return { glm::dvec4(0.0), 0.0 };
  }
  const double value = this->sign * extreme;
  const double opacity = this->scene.transferFunction.Opacity(value);
  return { glm::dvec4(opacity * this->scene.transferFunction.Color(value), opacity), 0.0 };
}

}
