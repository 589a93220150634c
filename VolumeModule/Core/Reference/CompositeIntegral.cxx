#include "Core/Reference/CompositeIntegral.h"

#include "Core/Reference/CellPieces.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

/// Emission and absorption along one ray, built up front to back.
class CompositeIntegral::Sum
{
public:
  Sum(const CompositeIntegral& integral, const MeasuredRay& ray)
    : integral(integral)
    , ray(ray)
  {
  }

  void AddCell(const CellPart& part, const CellCorners& corners);
  void AddGap(const CellPart& part);

  /// Whether what follows cannot be seen.
  bool Finished() const { return this->transmittance < 0.1 * this->integral.tolerance; }

  ReferenceColor Color() const;

private:
  void AddBand(const CellPiece& piece, const TransferBands::Band& band, double from, double to);
  void AddVarying(const CellPiece& piece, const TransferBands::Band& band, double from, double to,
    int bisections);
  void AddHomogeneous(const OpticalProperties& properties, double lengthMm);

  SlabQuadrature::Slab SlabOf(
    const CellPiece& piece, const TransferBands::Band& band, double from, double to) const;
  OpticalProperties PropertiesAt(
    const CellPiece& piece, const TransferBands::Band& band, double u) const;
  double LengthMm(const CellPiece& piece, double from, double to) const
  {
    return (to - from) * (piece.t.exit - piece.t.enter) * this->ray.mmPerParameter;
  }

  const CompositeIntegral& integral;
  const MeasuredRay& ray;
  PieceLight light; ///< of the cell that is being added, where the scene is shaded
  glm::dvec3 rgb = glm::dvec3(0.0);
  double transmittance = 1.0;
  double error = 0.0;
};

ReferenceColor CompositeIntegral::Sum::Color() const
{
  const double leftOut = this->Finished() ? this->transmittance : 0.0;
  return { glm::dvec4(this->rgb, 1.0 - this->transmittance), this->error + leftOut };
}

void CompositeIntegral::Sum::AddCell(const CellPart& part, const CellCorners& corners)
{
  const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end());
  if (!this->integral.bands.MayBeVisible(*lowest, *highest))
  {
    return;
  }
  const CellPiece piece = PieceOf(part, corners, this->ray.grid);
  if (this->integral.scene.shade)
  {
    this->light = this->integral.scene.shade(part, this->ray.grid);
  }
  CutIntoBands(piece.cubic, this->integral.bands,
    [&](const TransferBands::Band& band, double from, double to)
    {
      this->AddBand(piece, band, from, to);
      return !this->Finished();
    });
}

void CompositeIntegral::Sum::AddGap(const CellPart& part)
{
  this->AddHomogeneous(
    this->integral.scene.gap, (part.t.exit - part.t.enter) * this->ray.mmPerParameter);
}

void CompositeIntegral::Sum::AddBand(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to)
{
  if (band.kind == TransferBands::Kind::Invisible)
  {
    return;
  }
  const bool constant = band.kind == TransferBands::Kind::Constant && !this->integral.scene.shade;
  if (constant || band.kind == TransferBands::Kind::Opaque)
  {
    this->AddHomogeneous(this->PropertiesAt(piece, band, from), this->LengthMm(piece, from, to));
    return;
  }
  constexpr int mostBisections = 50;
  for (const double kink : this->light.kinks)
  {
    if (from < kink && kink < to)
    {
      this->AddVarying(piece, band, from, kink, mostBisections);
      from = kink;
    }
  }
  this->AddVarying(piece, band, from, to, mostBisections);
}

void CompositeIntegral::Sum::AddVarying(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to, int bisections)
{
  if (this->Finished())
  {
    return;
  }
  // A piece's share of the tolerance is its share of the ray, but not so small that a cut through
  // the end of a curve, where extinction may have a pole, never gets there.
  const double lengthMm = this->LengthMm(piece, from, to);
  const double share = std::max(lengthMm / this->ray.LengthMm(), 0.01);
  // Beyond this depth the colour may come from a layer so thin that all points miss it.
  constexpr double deepest = 2.0;
  const SlabQuadrature::Slab slab = this->SlabOf(piece, band, from, to);
  if (slab.opticalDepth <= deepest &&
    !(this->transmittance * slab.error > share * this->integral.tolerance))
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
    this->AddHomogeneous(this->PropertiesAt(piece, band, middle), lengthMm);
    return;
  }
  this->AddVarying(piece, band, from, middle, bisections - 1);
  this->AddVarying(piece, band, middle, to, bisections - 1);
}

SlabQuadrature::Slab CompositeIntegral::Sum::SlabOf(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to) const
{
  std::array<OpticalProperties, SlabQuadrature::PointCount> samples;
  for (int i = 0; i < SlabQuadrature::PointCount; ++i)
  {
    const double u = from + (to - from) * this->integral.quadrature.Points()[i];
    samples[i] = this->PropertiesAt(piece, band, u);
  }
  return this->integral.quadrature.Integral(samples, this->LengthMm(piece, from, to));
}

/// Max, "Optical models for direct volume rendering" (IEEE TVCG 1995), equation 7.
void CompositeIntegral::Sum::AddHomogeneous(const OpticalProperties& properties, double lengthMm)
{
  if (properties.extinction == 0.0 || !(lengthMm > 0.0))
  {
    return;
  }
  const double absorption = -std::expm1(-properties.extinction * lengthMm);
  this->rgb += this->transmittance * absorption * properties.rgb;
  this->transmittance *= std::exp(-properties.extinction * lengthMm);
}

OpticalProperties CompositeIntegral::Sum::PropertiesAt(
  const CellPiece& piece, const TransferBands::Band& band, double u) const
{
  OpticalProperties properties = this->integral.bands.Inside(band, piece.cubic.Value(u));
  if (this->light.emitted)
  {
    properties.rgb = this->light.emitted(properties.rgb, u);
  }
  return properties;
}

CompositeIntegral::CompositeIntegral(ReferenceScene givenScene, double tolerance)
  : scene(std::move(givenScene))
  , tolerance(tolerance)
  , bands(this->scene.transferFunction)
{
}

ReferenceColor CompositeIntegral::Along(const MeasuredRay& ray) const
{
  Sum sum(*this, ray);
  WalkCells(ray.grid, ray.inside,
    [&](const CellPart& part)
    {
      const CellCorners corners = this->scene.cornersOfCell(part.cell);
      if (AllFinite(corners))
      {
        sum.AddCell(part, corners);
      }
      else
      {
        sum.AddGap(part);
      }
      return !sum.Finished();
    });
  return sum.Color();
}

}
