#ifndef Varimarch_Core_Look_TransferFunction_h
#define Varimarch_Core_Look_TransferFunction_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace varimarch
{

/// Shape of the curve from a node to the next, with the meaning it has in vtkPiecewiseFunction.
/// @var midpoint  fraction of the way to the next node at which the curve is half way, [0, 1]
/// @var sharpness  0 for a linear curve, 1 for a step at the midpoint
struct NodeShape
{
  double midpoint = 0.5;
  double sharpness = 0.0;
};

/// The value at which the curve from one node to the next is half way: its midpoint, moved off the
/// nodes. A curve that sharpness turns into a step has its step here; this value belongs to the
/// right side.
double HalfWayValue(double leftValue, double rightValue, const NodeShape& shape);

struct OpacityNode
{
  double value;   ///< in units of the data
  double opacity; ///< per unit distance, [0, 1]
  NodeShape shape = {};
};

struct ColorNode
{
  double value;   ///< in units of the data
  glm::dvec3 rgb; ///< [0, 1]
  NodeShape shape = {};
};

/// A map from scalar value to colour and extinction: piecewise curves through nodes, constant
/// beyond the first and last. Two nodes at the same value make a step; that value belongs to its
/// left side.
class TransferFunction
{
public:
  /// @param colors  sorted by value, components clamped to [0, 1]; white if empty
  /// @param opacities  sorted by value, clamped to [0, 1]; opacity 0 if empty
  /// @param opacityUnitDistanceMm  distance over which the opacities hold [mm], > 0
  /// @throws std::invalid_argument if nodes are unsorted or not finite, or the distance is not > 0
  TransferFunction(std::vector<ColorNode> colors, std::vector<OpacityNode> opacities,
    double opacityUnitDistanceMm);

  glm::dvec3 Color(double value) const;

  /// Opacity per unit distance, [0, 1]; 0 for NaN.
  double Opacity(double value) const;

  /// Extinction [1/mm]: -log(1 - opacity) / unit distance, computed without cancellation. Infinite
  /// for opacity 1: such a material is opaque however thin it is.
  double Extinction(double value) const;

  /// First and last value at which anything changes; both 0 without nodes.
  double FirstValue() const;
  double LastValue() const;

  /// True if all curves between nodes are straight and there is no step.
  bool IsPiecewiseLinear() const;

  /// Smallest distance between two nodes at different values; infinite if there are none.
  double SmallestNodeGap() const;

  const std::vector<ColorNode>& Colors() const { return this->colors; }
  const std::vector<OpacityNode>& Opacities() const { return this->opacities; }
  double OpacityUnitDistanceMm() const { return this->opacityUnitDistanceMm; }

private:
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  double opacityUnitDistanceMm;
};

/// Colour and extinction at equidistant values, for linear interpolation between entries. Entry i
/// holds (r, g, b, extinction [1/mm]) at firstValue + i * (lastValue - firstValue) / (entries - 1);
/// the end entries hold for all values beyond. If firstValue equals lastValue, all entries are
/// equal. An opaque value has OpaqueExtinction, which is finite, so that it can be multiplied by
/// zero and interpolated without a NaN.
struct OpticalTable
{
  double firstValue;
  double lastValue;
  std::vector<glm::vec4> entries; ///< at least two
};

/// Extinction of opaque values [1/mm]. Large enough that the thinnest segment is opaque, and small
/// enough that its product with any length fits a float.
constexpr float OpaqueExtinction = 1e30f;

/// Samples a transfer function over the part of [smallestValue, largestValue] in which it changes,
/// on all cores. The number of entries is a power of two, from 1024 to `mostEntries`, with at least
/// 32 between neighbouring nodes; it is `mostEntries` for a function with a step, which becomes a
/// ramp one entry wide, and two if nothing changes. A peak between two entries becomes one entry
/// wide and keeps its integral of extinction over the values.
/// @throws std::invalid_argument unless both values are finite and smallestValue <= largestValue
OpticalTable BuildOpticalTable(const TransferFunction& transferFunction, double smallestValue,
  double largestValue, std::size_t mostEntries = 65536);

/// A scalar's index in a table is scalar * scale + bias.
struct IndexInTable
{
  double scale;
  double bias;
};

/// The index of scalars that stand for the values scalar * valueScale + valueOffset; 0 in a table
/// whose first value is its last.
/// @param lastIndex  index of the table's last value
IndexInTable IndexOf(
  const OpticalTable& table, double lastIndex, double valueScale = 1.0, double valueOffset = 0.0);

/// The open range of values in which a table has any extinction. An end is infinite if the end
/// entry has extinction; the range is (infinity, -infinity) if no entry has.
std::array<double, 2> VisibleValues(const OpticalTable& table);

}

#endif
