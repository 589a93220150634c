#include "Core/ReferenceIntegrator.h"

#include "Core/CellWalk.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

/// A ray, and how long its parameter is.
struct MeasuredRay
{
  Ray grid;
  double mmPerParameter;
  double lengthMm; ///< of the part that counts
};

/// The cubic in a cell, or in what is left of one, over the ray's parameter.
struct CellPiece
{
  CellCubic cubic;
  Interval t;

  double ParameterAt(double u) const { return this->t.enter + u * (this->t.exit - this->t.enter); }
};

CellPiece PieceOf(const CellPart& part, const CellCorners& corners, const Ray& ray)
{
  // Round-off may put an end just outside the cell.
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

/// The integral of emission and absorption, built up front to back.
class CompositeSum
{
public:
  CompositeSum(const ReferenceScene& scene, const TransferBands& bands,
    const SlabQuadrature& quadrature, double tolerance)
    : scene(scene)
    , bands(bands)
    , quadrature(quadrature)
    , tolerance(tolerance)
  {
  }

  ReferenceColor Of(const MeasuredRay& ray, Interval inside);

private:
  void AddCell(const CellPart& part);
  void AddOneValue(const CellPiece& piece, double value, double from, double to);
  void AddMonotone(const CellPiece& piece, double from, double to);
  void AddBand(const CellPiece& piece, const TransferBands::Band& band, double from, double to);
  void AddVarying(const CellPiece& piece, const TransferBands::Band& band, double from, double to,
    int bisections);
  void AddHomogeneous(const OpticalProperties& properties, double lengthMm);

  SlabQuadrature::Slab SlabOf(
    const CellPiece& piece, const TransferBands::Band& band, double from, double to) const;
  OpticalProperties Shaded(OpticalProperties properties, double t) const;
  double LengthMm(const CellPiece& piece, double from, double to) const
  {
    return (to - from) * (piece.t.exit - piece.t.enter) * this->ray.mmPerParameter;
  }
  bool Finished() const { return this->transmittance < 0.1 * this->tolerance; }

  const ReferenceScene& scene;
  const TransferBands& bands;
  const SlabQuadrature& quadrature;
  double tolerance;

  MeasuredRay ray = {};
  glm::dvec3 rgb = glm::dvec3(0.0);
  double transmittance = 1.0;
  double error = 0.0;
};

ReferenceColor CompositeSum::Of(const MeasuredRay& measuredRay, Interval inside)
{
  this->ray = measuredRay;
  WalkCells(this->ray.grid, inside,
    [&](const CellPart& part)
    {
      this->AddCell(part);
      return !this->Finished();
    });
  const double leftOut = this->Finished() ? this->transmittance : 0.0;
  return { glm::dvec4(this->rgb, 1.0 - this->transmittance), this->error + leftOut };
}

void CompositeSum::AddCell(const CellPart& part)
{
  const CellCorners corners = this->scene.cornersOfCell(part.cell);
  const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end());
  if (!this->bands.MayBeVisible(*lowest, *highest) || !AllFinite(corners))
  {
    return;
  }
  const CellPiece piece = PieceOf(part, corners, this->ray.grid);
  if (*lowest == *highest)
  {
    this->AddOneValue(piece, *lowest, 0.0, 1.0);
    return;
  }

  // Most cells lie within one band.
  const int band = this->bands.BandAbove(piece.cubic.LowerBound());
  if (band == this->bands.BandBelow(piece.cubic.UpperBound()))
  {
    this->AddBand(piece, this->bands[band], 0.0, 1.0);
    return;
  }
  const CellCubic::Cuts cuts = piece.cubic.MonotoneCuts();
  for (int i = 0; i + 1 < cuts.count && !this->Finished(); ++i)
  {
    this->AddMonotone(piece, cuts.u[i], cuts.u[i + 1]);
  }
}

/// A piece with one value, which may be that of a node.
void CompositeSum::AddOneValue(const CellPiece& piece, double value, double from, double to)
{
  const OpticalProperties properties = this->bands.At(value);
  if (this->scene.shade && std::isfinite(properties.extinction))
  {
    this->AddBand(piece, this->bands[this->bands.BandBelow(value)], from, to);
    return;
  }
  this->AddHomogeneous(
    this->Shaded(properties, piece.ParameterAt(from)), this->LengthMm(piece, from, to));
}

/// Cuts where a monotone piece of a cell goes from band to band.
void CompositeSum::AddMonotone(const CellPiece& piece, double from, double to)
{
  const double first = piece.cubic.Value(from);
  const double last = piece.cubic.Value(to);
  if (first == last)
  {
    this->AddOneValue(piece, first, from, to);
    return;
  }
  const bool ascending = first < last;
  int band = ascending ? this->bands.BandAbove(first) : this->bands.BandBelow(first);
  while (from < to && !this->Finished())
  {
    const double bound = ascending ? this->bands[band].upper : this->bands[band].lower;
    const bool leaves = ascending ? bound < last : bound > last;
    const double end = leaves ? piece.cubic.Crossing(bound, from, to) : to;
    this->AddBand(piece, this->bands[band], from, end);
    from = end;
    band += ascending ? 1 : -1;
  }
}

void CompositeSum::AddBand(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to)
{
  if (!(from < to) || band.kind == TransferBands::Kind::Invisible)
  {
    return;
  }
  const bool constant = band.kind == TransferBands::Kind::Constant && !this->scene.shade;
  if (constant || band.kind == TransferBands::Kind::Opaque)
  {
    const OpticalProperties atEntry = this->bands.Inside(band, piece.cubic.Value(from));
    this->AddHomogeneous(
      this->Shaded(atEntry, piece.ParameterAt(from)), this->LengthMm(piece, from, to));
    return;
  }
  constexpr int mostBisections = 50;
  this->AddVarying(piece, band, from, to, mostBisections);
}

void CompositeSum::AddVarying(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to, int bisections)
{
  if (this->Finished())
  {
    return;
  }
  // A piece's share of the tolerance is its share of the ray, but not so small that a cut through
  // the end of a curve, where extinction may have a pole, never gets there.
  const double lengthMm = this->LengthMm(piece, from, to);
  const double share = std::max(lengthMm / this->ray.lengthMm, 0.01);
  // Beyond this depth the colour may come from a layer so thin that all points miss it.
  constexpr double deepest = 2.0;
  const SlabQuadrature::Slab slab = this->SlabOf(piece, band, from, to);
  if (slab.opticalDepth <= deepest && !(this->transmittance * slab.error > share * this->tolerance))
  {
    this->rgb += this->transmittance * slab.rgb;
    this->error += this->transmittance * slab.error;
    this->transmittance *= std::exp(-slab.opticalDepth);
    return;
  }
  const double middle = 0.5 * (from + to);
  if (bisections == 0)
  {
    // As thin as round-off: what is this dense here is a surface.
    this->error += this->transmittance * std::min(1.0, slab.opticalDepth);
    const OpticalProperties properties = this->bands.Inside(band, piece.cubic.Value(middle));
    this->AddHomogeneous(this->Shaded(properties, piece.ParameterAt(middle)), lengthMm);
    return;
  }
  this->AddVarying(piece, band, from, middle, bisections - 1);
  this->AddVarying(piece, band, middle, to, bisections - 1);
}

SlabQuadrature::Slab CompositeSum::SlabOf(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to) const
{
  std::array<OpticalProperties, SlabQuadrature::PointCount> samples;
  for (int i = 0; i < SlabQuadrature::PointCount; ++i)
  {
    const double u = from + (to - from) * this->quadrature.Points()[i];
    samples[i] = this->Shaded(this->bands.Inside(band, piece.cubic.Value(u)), piece.ParameterAt(u));
  }
  return this->quadrature.Integral(samples, this->LengthMm(piece, from, to));
}

/// Max, "Optical models for direct volume rendering" (IEEE TVCG 1995), equation 7.
void CompositeSum::AddHomogeneous(const OpticalProperties& properties, double lengthMm)
{
  if (properties.extinction == 0.0 || !(lengthMm > 0.0))
  {
    return;
  }
  const double absorption = -std::expm1(-properties.extinction * lengthMm);
  this->rgb += this->transmittance * absorption * properties.rgb;
  this->transmittance *= std::exp(-properties.extinction * lengthMm);
}

OpticalProperties CompositeSum::Shaded(OpticalProperties properties, double t) const
{
  if (this->scene.shade)
  {
    properties.rgb = this->scene.shade(properties.rgb,
      this->ray.grid.origin + t * this->ray.grid.direction, this->ray.grid.direction);
  }
  return properties;
}

}

ReferenceIntegrator::ReferenceIntegrator(ReferenceScene scene, double tolerance)
  : scene(std::move(scene))
  , tolerance(tolerance)
  , bands(this->scene.transferFunction)
{
  if (!(tolerance >= SmallestTolerance))
  {
    throw std::invalid_argument(
      "Reference: the tolerance must be 1e-12 or more, found " + std::to_string(tolerance));
  }
  if (!this->scene.cornersOfCell)
  {
    throw std::invalid_argument("Reference: the scene must have voxels, found none");
  }
}

ReferenceColor ReferenceIntegrator::Color(
  const Ray& rayGrid, double mmPerParameter, Interval limits) const
{
  const Interval inside = Intersection(rayGrid, this->scene.boxGrid, limits);
  if (inside.IsEmpty())
  {
    return { glm::dvec4(0.0), 0.0 };
  }
  if (this->scene.blend == Blend::MaximumIntensity)
  {
    return this->MaximumColor(rayGrid, inside);
  }
  CompositeSum sum(this->scene, this->bands, this->quadrature, this->tolerance);
  return sum.Of({ rayGrid, mmPerParameter, (inside.exit - inside.enter) * mmPerParameter }, inside);
}

ReferenceColor ReferenceIntegrator::MaximumColor(const Ray& rayGrid, Interval inside) const
{
  double largest = -std::numeric_limits<double>::infinity();
  WalkCells(rayGrid, inside,
    [&](const CellPart& part)
    {
      const CellCorners corners = this->scene.cornersOfCell(part.cell);
      if (AllFinite(corners) && *std::max_element(corners.begin(), corners.end()) > largest)
      {
        const CellPiece piece = PieceOf(part, corners, rayGrid);
        const CellCubic::Cuts cuts = piece.cubic.MonotoneCuts();
        for (int i = 0; i < cuts.count; ++i)
        {
          largest = std::max(largest, piece.cubic.Value(cuts.u[i]));
        }
      }
      return true;
    });
  if (!std::isfinite(largest))
  {
    return { glm::dvec4(0.0), 0.0 };
  }
  const double opacity = this->scene.transferFunction.Opacity(largest);
  return { glm::dvec4(opacity * this->scene.transferFunction.Color(largest), opacity), 0.0 };
}

}
