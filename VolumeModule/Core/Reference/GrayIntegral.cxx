#include "Core/Reference/GrayIntegral.h"

#include "Core/Reference/CellPieces.h"

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr ValueRange everything = { -std::numeric_limits<double>::infinity(),
  std::numeric_limits<double>::infinity() };

}

/// A part of a ray in one cell and one band.
struct GrayIntegral::Part
{
  const CellPiece& piece;
  const TransferBands::Band& band;
  double mmPerU;
  double errorPerMm;
};

GrayIntegral::GrayIntegral(ReferenceScene givenScene, double tolerance)
  : scene(std::move(givenScene))
  , tolerance(tolerance)
  , bands(TransferFunction({}, this->scene.transferFunction.Opacities(), 1.0),
      { this->scene.averagedRange.lower, this->scene.averagedRange.upper })
{
}

GrayIntegral::Sum GrayIntegral::SumAlong(
  const MeasuredRay& ray, ValueRange counted, double errorPerMm) const
{
  Sum sum;
  WalkFiniteCells(this->scene, ray,
    [&](const CellPart& cellPart, const CellCorners& corners)
    {
      const CellPiece piece = PieceOf(cellPart, corners, ray.grid);
      const double mmPerU = (piece.t.exit - piece.t.enter) * ray.mmPerParameter;
      CutIntoBands(piece.cubic, this->bands,
        [&](const TransferBands::Band& band, double from, double to)
        {
          const double value = band.Kept(piece.cubic.Value(0.5 * (from + to)));
          if (counted.lower <= value && value <= counted.upper)
          {
            constexpr int mostBisections = 50;
            this->AddPart(sum, { piece, band, mmPerU, errorPerMm }, from, to, mostBisections);
          }
          return true;
        });
      return true;
    });
  return sum;
}

void GrayIntegral::AddPart(Sum& sum, const Part& part, double from, double to, int bisections) const
{
  const ValueRange gray = this->scene.grayRange;
  const double perValue = gray.lower < gray.upper ? 1.0 / (gray.upper - gray.lower) : 0.0;
  std::array<double, SlabQuadrature::PointCount> samples;
  for (int i = 0; i < SlabQuadrature::PointCount; ++i)
  {
    const double u = from + (to - from) * this->quadrature.Points()[i];
    const double value = part.band.Kept(part.piece.cubic.Value(u));
    samples[i] = this->scene.transferFunction.Opacity(value) * (value - gray.lower) * perValue;
  }
  const double lengthMm = (to - from) * part.mmPerU;
  const SlabQuadrature::Estimate estimate = this->quadrature.Integral(samples, lengthMm);
  if (bisections > 0 && estimate.error > part.errorPerMm * lengthMm)
  {
    const double middle = 0.5 * (from + to);
    this->AddPart(sum, part, from, middle, bisections - 1);
    this->AddPart(sum, part, middle, to, bisections - 1);
    return;
  }
  sum.integral += estimate.value;
  sum.lengthMm += lengthMm;
  sum.error += estimate.error;
}

ReferenceColor GrayIntegral::White(const Sum& sum, double perMm)
{
  if (sum.lengthMm == 0.0)
  {
    return { glm::dvec4(0.0), 0.0 };
  }
  const double intensity = std::clamp(sum.integral * perMm, 0.0, 1.0);
  return { glm::dvec4(glm::dvec3(intensity), 1.0), sum.error * perMm };
}

AverageIntegral::AverageIntegral(ReferenceScene scene, double tolerance)
  : GrayIntegral(std::move(scene), tolerance)
{
}

ReferenceColor AverageIntegral::Along(const MeasuredRay& ray) const
{
  const Sum sum = this->SumAlong(ray, this->scene.averagedRange, this->tolerance);
  return White(sum, 1.0 / sum.lengthMm);
}

AdditiveIntegral::AdditiveIntegral(ReferenceScene scene, double tolerance)
  : GrayIntegral(std::move(scene), tolerance)
{
}

ReferenceColor AdditiveIntegral::Along(const MeasuredRay& ray) const
{
  const double perMm = 1.0 / this->scene.transferFunction.OpacityUnitDistanceMm();
  const double errorPerMm = this->tolerance / (perMm * ray.LengthMm());
  const Sum sum = this->SumAlong(ray, everything, errorPerMm);
  return White(sum, perMm);
}

}
