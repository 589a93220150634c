#ifndef Varimarch_Core_Reference_CellPieces_h
#define Varimarch_Core_Reference_CellPieces_h

#include "Core/Geometry/CellWalk.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// The part of a ray in one cell, and its values as a cubic over u in [0, 1].
struct CellPiece
{
  CellCubic cubic;
  Interval t;

  double ParameterAt(double u) const { return this->t.enter + u * (this->t.exit - this->t.enter); }
};

CellPiece PieceOf(const CellPart& part, const CellCorners& corners, const Ray& ray);

bool AllFinite(const CellCorners& corners);

/// Calls visit(part) for the cells along all parts of a ray, front to back, until it returns false.
template <class Visit>
void WalkCells(const MeasuredRay& ray, Visit visit)
{
  bool goesOn = true;
  for (auto part = ray.parts.begin(); part != ray.parts.end() && goesOn; ++part)
  {
    WalkCells(ray.grid, *part,
      [&](const CellPart& cellPart)
      {
        goesOn = visit(cellPart);
        return goesOn;
      });
  }
}

/// Calls visit(part, corners) for the cells along a ray whose voxels are all finite, front to back,
/// until it returns false.
template <class Visit>
void WalkFiniteCells(const ReferenceScene& scene, const MeasuredRay& ray, Visit visit)
{
  WalkCells(ray,
    [&](const CellPart& part)
    {
      const CellCorners corners = scene.cornersOfCell(part.cell);
      return !AllFinite(corners) || visit(part, corners);
    });
}

/// Divides a monotone part of a cubic at the bounds of bands; see CutIntoBands.
template <class Visit>
bool CutMonotoneIntoBands(
  const CellCubic& cubic, const TransferBands& bands, double from, double to, Visit& visit)
{
  const double first = cubic.Value(from);
  const double last = cubic.Value(to);
  if (first == last)
  {
    return visit(bands.OnlyAt(first), from, to);
  }
  const bool ascending = first < last;
  int band = ascending ? bands.BandAbove(first) : bands.BandBelow(first);
  while (from < to)
  {
    const double bound = ascending ? bands[band].upper : bands[band].lower;
    const bool leaves = ascending ? bound < last : bound > last;
    const double end = leaves ? cubic.Crossing(bound, from, to) : to;
    if (from < end && !visit(bands[band], from, end))
    {
      return false;
    }
    from = end;
    band += ascending ? 1 : -1;
  }
  return true;
}

/// Calls visit(band, from, to) for the parts [from, to] of [0, 1] on which the cubic stays within
/// one band of values, in order, until it returns false. No part is empty.
template <class Visit>
void CutIntoBands(const CellCubic& cubic, const TransferBands& bands, Visit visit)
{
  const double lower = cubic.LowerBound();
  const double upper = cubic.UpperBound();
  if (lower == upper)
  {
    visit(bands.OnlyAt(lower), 0.0, 1.0);
    return;
  }
  // Most cells lie within one band.
  const int band = bands.BandAbove(lower);
  if (band == bands.BandBelow(upper))
  {
    visit(bands[band], 0.0, 1.0);
    return;
  }
  const CellCubic::Cuts cuts = cubic.MonotoneCuts();
  bool goesOn = true;
  for (int i = 0; i + 1 < cuts.count && goesOn; ++i)
  {
    goesOn = CutMonotoneIntoBands(cubic, bands, cuts.u[i], cuts.u[i + 1], visit);
  }
}

}

#endif
