#include "Core/Reference/CompositeIntegral.h"

#include "Core/Reference/CellPieces.h"
#include "Core/Reference/CompositeSum.h"

#include <algorithm>

namespace varimarch
{

/// Accumulates the cells along one ray.
class CompositeIntegral::Cells
{
public:
  Cells(const CompositeIntegral& integral, const MeasuredRay& ray)
    : integral(integral)
    , ray(ray)
    , sum(integral.quadrature, integral.tolerance, ray.LengthMm())
  {
  }

  void AddCell(const CellPart& part, const CellCorners& corners);
  void AddGap(const CellPart& part);
  const CompositeSum& Sum() const { return this->sum; }

private:
  void AddBand(const CellPiece& piece, const TransferBands::Band& band, double from, double to);
  OpticalProperties PropertiesAt(
    const CellPiece& piece, const TransferBands::Band& band, double u) const;

  const CompositeIntegral& integral;
  const MeasuredRay& ray;
  PieceLight light; ///< light in the current cell of a shaded scene
  CompositeSum sum;
};

void CompositeIntegral::Cells::AddCell(const CellPart& part, const CellCorners& corners)
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
      return !this->sum.Finished();
    });
}

void CompositeIntegral::Cells::AddGap(const CellPart& part)
{
  this->sum.AddHomogeneous(
    this->integral.scene.gap, (part.t.exit - part.t.enter) * this->ray.mmPerParameter);
}

void CompositeIntegral::Cells::AddBand(
  const CellPiece& piece, const TransferBands::Band& band, double from, double to)
{
  if (band.kind == TransferBands::Kind::Invisible)
  {
    return;
  }
  const double mmPerU = (piece.t.exit - piece.t.enter) * this->ray.mmPerParameter;
  const auto propertiesAt = [&](double u) { return this->PropertiesAt(piece, band, u); };
  const bool constant = band.kind == TransferBands::Kind::Constant && !this->integral.scene.shade;
  if (constant || band.kind == TransferBands::Kind::Opaque)
  {
    this->sum.AddHomogeneous(propertiesAt(from), (to - from) * mmPerU);
    return;
  }
  for (const double kink : this->light.kinks)
  {
    if (from < kink && kink < to)
    {
      this->sum.AddVarying(propertiesAt, from, kink, mmPerU);
      from = kink;
    }
  }
  this->sum.AddVarying(propertiesAt, from, to, mmPerU);
}

OpticalProperties CompositeIntegral::Cells::PropertiesAt(
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
  Cells cells(*this, ray);
  WalkCells(ray,
    [&](const CellPart& part)
    {
      const CellCorners corners = this->scene.cornersOfCell(part.cell);
      if (AllFinite(corners))
      {
        cells.AddCell(part, corners);
      }
      else
      {
        cells.AddGap(part);
      }
      return !cells.Sum().Finished();
    });
  return cells.Sum().Color();
}

}
