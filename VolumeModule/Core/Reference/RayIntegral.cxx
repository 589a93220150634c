#include "Core/Reference/RayIntegral.h"

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/CellPieces.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace varimarch
{
namespace
{

/// Emission and absorption along one ray, accumulated front to back.
class CompositeSum
{
public:
  /// @param tolerance  largest accepted error of a channel
  CompositeSum(const SlabQuadrature& quadrature, double tolerance, double rayLengthMm)
    : quadrature(quadrature)
    , tolerance(tolerance)
    , rayLengthMm(rayLengthMm)
  {
  }

  /// True if nothing behind can be seen.
  bool Finished() const { return this->transmittance < 0.1 * this->tolerance; }

  ReferenceColor Color() const;

  void AddHomogeneous(const OpticalProperties& properties, double lengthMm);

  /// Adds a part in which the optical properties are smooth, or nearly so.
  /// @param propertiesAt  returns the OpticalProperties at a parameter in (from, to)
  template <class PropertiesAt>
  void AddVarying(const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter);

private:
  template <class PropertiesAt>
  void AddBisected(const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter,
    int bisections);

  const SlabQuadrature& quadrature;
  double tolerance;
  double rayLengthMm;
  glm::dvec3 rgb = glm::dvec3(0.0);
  double transmittance = 1.0;
  double error = 0.0;
};

template <class PropertiesAt>
void CompositeSum::AddVarying(
  const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter)
{
  constexpr int mostBisections = 50;
  this->AddBisected(propertiesAt, from, to, mmPerParameter, mostBisections);
}

template <class PropertiesAt>
void CompositeSum::AddBisected(
  const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter, int bisections)
{
  if (this->Finished())
  {
    return;
  }
  // A piece may use the fraction of the tolerance that it has of the ray's length. A lower limit
  // lets the bisection end where it cuts through the end of a curve, at which extinction may have a
  // pole.
  const double lengthMm = (to - from) * mmPerParameter;
  const double share = std::max(lengthMm / this->rayLengthMm, 0.01);
  std::array<OpticalProperties, SlabQuadrature::PointCount> samples;
  for (int i = 0; i < SlabQuadrature::PointCount; ++i)
  {
    samples[i] = propertiesAt(from + (to - from) * this->quadrature.Points()[i]);
  }
  // In deeper pieces the colour may come from a layer so thin that all points miss it.
  constexpr double deepest = 2.0;
  const SlabQuadrature::Slab slab = this->quadrature.Integral(samples, lengthMm);
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
    // The piece is as thin as rounding errors; matter so dense is treated as a surface.
    this->error += this->transmittance * std::min(1.0, slab.opticalDepth);
    this->AddHomogeneous(propertiesAt(middle), lengthMm);
    return;
  }
  this->AddBisected(propertiesAt, from, middle, mmPerParameter, bisections - 1);
  this->AddBisected(propertiesAt, middle, to, mmPerParameter, bisections - 1);
}

ReferenceColor CompositeSum::Color() const
{
  const double leftOut = this->Finished() ? this->transmittance : 0.0;
  return { glm::dvec4(this->rgb, 1.0 - this->transmittance), this->error + leftOut };
}

/// Source: Max, "Optical models for direct volume rendering" (IEEE TVCG 1995), equation 7.
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

/// The volume rendering integral of emission and absorption.
///
/// The ray is divided at all cell faces and, inside a cell, wherever its cubic crosses a node of
/// the transfer function. The pieces are smooth and are integrated adaptively (SlabQuadrature);
/// invisible, constant and opaque pieces are exact. See Documentation/Mathematics.md.
class CompositeIntegral : public RayIntegral
{
public:
  CompositeIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  class Cells;

  ReferenceScene scene;
  double tolerance;
  TransferBands bands;
  SlabQuadrature quadrature;
};

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

/// The volume rendering integral of any material. Uses only the scene's box and its material.
///
/// The ray is divided at the faces of cells and halfway between, where labels of voxels change.
/// Pieces are bisected until the quadrature finds them smooth enough. This needs no knowledge of a
/// material's kinks, but is slow.
class MaterialIntegral : public RayIntegral
{
public:
  MaterialIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene;
  double tolerance;
  SlabQuadrature quadrature;
};

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

enum class Extreme
{
  Largest,
  Smallest,
};

/// Maximum and minimum intensity: the extreme value along the ray, through the transfer function,
/// over one unit distance. Exact up to rounding.
class ExtremeIntegral : public RayIntegral
{
public:
  ExtremeIntegral(ReferenceScene scene, Extreme extreme);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene;
  double sign; ///< 1 or -1: the extreme is the largest sign * value
};

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

/// Base of average and additive intensity: the integral of opacity(v) * gray(v) along a ray, where
/// gray(v) rises from 0 to 1 over the scene's gray range. See Documentation/Mathematics.md.
class GrayIntegral : public RayIntegral
{
protected:
  GrayIntegral(ReferenceScene scene, double tolerance);

  struct Sum
  {
    double integral = 0.0; ///< [mm]
    double lengthMm = 0.0; ///< length of the parts that count [mm]
    double error = 0.0;    ///< estimated error of the integral
  };

  /// @param counted  range of the values that count
  /// @param errorPerMm  largest accepted error of the integral, per length
  Sum SumAlong(const MeasuredRay& ray, ValueRange counted, double errorPerMm) const;

  /// The sum times a factor, at most 1, as white on black; transparent if nothing counts.
  static ReferenceColor White(const Sum& sum, double perMm);

  ReferenceScene scene;
  double tolerance;

private:
  struct Part;
  void AddPart(Sum& sum, const Part& part, double from, double to, int bisections) const;

  TransferBands bands; ///< bands of the opacity, also divided at the ends of the averaged range
  SlabQuadrature quadrature;
};

/// The mean of opacity * gray over the parts of the ray whose values are in the averaged range.
class AverageIntegral : public GrayIntegral
{
public:
  AverageIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

/// The integral of opacity * gray, with lengths in unit distances.
class AdditiveIntegral : public GrayIntegral
{
public:
  AdditiveIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

constexpr ValueRange everything = { -std::numeric_limits<double>::infinity(),
  std::numeric_limits<double>::infinity() };

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

/// Surfaces of equal value, front to back. Each has the colour (shaded if the scene is) and the
/// opacity that the transfer function assigns to its value. A ray passes a surface where it goes
/// from below the isovalue to at least the isovalue, or back. The faces of the volume are not
/// surfaces. Exact up to rounding.
class IsosurfaceIntegral : public RayIntegral
{
public:
  /// Ignores isovalues that are not finite.
  explicit IsosurfaceIntegral(ReferenceScene scene);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene; ///< with sorted, unique isovalues
};

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

std::unique_ptr<const RayIntegral> NewRayIntegral(ReferenceScene scene, double tolerance)
{
  switch (scene.blend)
  {
    case Blend::Composite:
      if (scene.material)
      {
        return std::make_unique<MaterialIntegral>(std::move(scene), tolerance);
      }
      return std::make_unique<CompositeIntegral>(std::move(scene), tolerance);
    case Blend::MaximumIntensity:
      return std::make_unique<ExtremeIntegral>(std::move(scene), Extreme::Largest);
    case Blend::MinimumIntensity:
      return std::make_unique<ExtremeIntegral>(std::move(scene), Extreme::Smallest);
    case Blend::AverageIntensity:
      return std::make_unique<AverageIntegral>(std::move(scene), tolerance);
    case Blend::Additive:
      return std::make_unique<AdditiveIntegral>(std::move(scene), tolerance);
    case Blend::Isosurface:
      return std::make_unique<IsosurfaceIntegral>(std::move(scene));
    case Blend::Slice:
      break;
  }
  throw std::invalid_argument(
    "Reference image: slices are not supported; choose another blend mode");
}

}
