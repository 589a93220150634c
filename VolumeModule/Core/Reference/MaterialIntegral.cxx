#include "Core/Reference/MaterialIntegral.h"

#include "Core/Reference/CellPieces.h"
#include "Core/Reference/CompositeSum.h"

#include <utility>

namespace varimarch
{

MaterialIntegral::MaterialIntegral(ReferenceScene scene, double tolerance)
  : scene(std::move(scene))
  , tolerance(tolerance)
{
}

ReferenceColor MaterialIntegral::Along(const MeasuredRay& ray) const
{
  CompositeSum sum(this->quadrature, this->tolerance, ray.LengthMm());
  const auto materialAt = [&](double t)
  { return this->scene.material(ray.PositionGrid(t), ray.grid); };
  const Ray halfCells{ 2.0 * ray.grid.origin, 2.0 * ray.grid.direction };
  WalkCells(MeasuredRay{ halfCells, ray.mmPerParameter, ray.parts },
    [&](const CellPart& part)
    {
      sum.AddVarying(materialAt, part.t.enter, part.t.exit, ray.mmPerParameter);
      return !sum.Finished();
    });
  return sum.Color();
}

}
