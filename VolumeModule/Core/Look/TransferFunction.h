#ifndef Varimarch_Core_Look_TransferFunction_h
#define Varimarch_Core_Look_TransferFunction_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace varimarch
{

/// How a curve runs from a node to the next, with the meaning of vtkPiecewiseFunction.
/// @var midpoint   where between the two nodes the curve reaches half way, in [0, 1]
/// @var sharpness  0 is linear, 1 a step at the midpoint
struct NodeShape
{
  double midpoint = 0.5;
  double sharpness = 0.0;
};

/// The value at which the curve from one node to the next is half way: its midpoint, kept off the
/// nodes. Where sharpness makes a step, the step is exactly here, the value on its right side.
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

/// Scalar value to colour and extinction: piecewise curves through nodes, constant beyond the
/// first and last. Two nodes at one value make a step; the value itself belongs to the left side.
class TransferFunction
{
public:
  /// @param colors     sorted by value, components clamped to [0, 1]; empty means white
  /// @param opacities  sorted by value, clamped to [0, 1]; empty means opacity 0
  /// @param opacityUnitDistanceMm  the distance [mm] over which the opacities hold, > 0
  /// @throws std::invalid_argument for unsorted or non-finite nodes, or a distance not > 0
  TransferFunction(std::vector<ColorNode> colors, std::vector<OpacityNode> opacities,
    double opacityUnitDistanceMm);

  glm::dvec3 Color(double value) const;

  /// Opacity per unit distance, [0, 1]; 0 for NaN: what is not a number does not show.
  double Opacity(double value) const;

  /// Extinction [1/mm]: -log(1 - opacity) / unit distance, computed without cancellation.
  /// Infinity where the opacity is 1: nothing shows through an opaque material however thin.
  double Extinction(double value) const;

  /// First and last value at which anything changes; {0, 0} without nodes.
  double FirstValue() const;
  double LastValue() const;

  /// Whether all curves between nodes are straight, and none jumps.
  bool IsPiecewiseLinear() const;

  /// Smallest distance between two nodes that lie at different values; infinity for fewer.
  double SmallestNodeGap() const;

  const std::vector<ColorNode>& Colors() const { return this->colors; }
  const std::vector<OpacityNode>& Opacities() const { return this->opacities; }
  double OpacityUnitDistanceMm() const { return this->opacityUnitDistanceMm; }

private:
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  double opacityUnitDistanceMm;
};

/// Colour and extinction sampled at equal distances, for linear interpolation between entries.
/// Entry i holds (r, g, b, extinction [1/mm]) at firstValue + i * (lastValue - firstValue) /
/// (entries - 1); the end entries hold for all values beyond. Where the range is a single value,
/// firstValue equals lastValue and the entries are equal. An opaque value holds OpaqueExtinction,
/// which is finite, so that it can be multiplied by zero and interpolated without a NaN.
struct OpticalTable
{
  double firstValue;
  double lastValue;
  std::vector<glm::vec4> entries; ///< at least two
};

/// [1/mm]. Large enough that the thinnest segment is opaque, small enough that a float can hold
/// its product with any length.
constexpr float OpaqueExtinction = 1e30f;

/// Samples a transfer function over the part of [smallestValue, largestValue] where it changes,
/// on all cores. The number of entries is a power of two with at least 32 from each node to the
/// next, at least 1024 and at most `mostEntries`, as many as that for functions with a step, which
/// becomes a ramp one entry wide; where nothing changes it is two. A peak between two entries
/// becomes one of their width, of the same integral of extinction over the values.
/// @throws std::invalid_argument unless smallestValue <= largestValue, both finite
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

/// The values between which a table has any extinction, neither of them included: infinite where
/// the end entries have, (infinity, -infinity) where none has.
std::array<double, 2> VisibleValues(const OpticalTable& table);

}

#endif
