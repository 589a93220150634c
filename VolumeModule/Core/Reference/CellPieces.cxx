#include "Core/Reference/CellPieces.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

CellPiece PieceOf(const CellPart& part, const CellCorners& corners, const Ray& ray)
{
  // Rounding may place an end just outside the cell.
  const auto place = [&](double t)
  {
    const glm::dvec3 position = ray.origin + t * ray.direction - glm::dvec3(part.cell);
    return glm::clamp(position, 0.0, 1.0);
  };
  return { CellCubic(corners, place(part.t.enter), place(part.t.exit)), part.t };
}

bool AllFinite(const CellCorners& corners)
{
  return std::all_of(corners.begin(), corners.end(), [](double v) { return std::isfinite(v); });
}

}
