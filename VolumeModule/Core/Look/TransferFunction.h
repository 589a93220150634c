#ifndef Varimarch_Core_Look_TransferFunction_h
#define Varimarch_Core_Look_TransferFunction_h

#include "Core/Look/ValueRange.h"

#include <glm/vec3.hpp>

#include <optional>
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

/// True if no number lies between the values of two neighbouring nodes.
bool AreSidesOfStep(double leftValue, double rightValue);

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

/// A jump of a curve at a value, which itself belongs to one of its sides.
struct Step
{
  double value;
  bool valueIsLeft; ///< True if the value looks like those just below it.
};

/// The value of a step that is nearer than a distance, or else the value itself: a computed value
/// that rounding may have moved off a step.
/// @param steps  ascending by value
double SnappedToStep(const std::vector<Step>& steps, double value, double distance);

/// A map from scalar value to colour and extinction: piecewise curves through nodes, constant
/// beyond the first and last. Two nodes at the same value make a step; that value belongs to its
/// left side. If no number lies between the values of two nodes, they make a step whose value, that
/// of the right node, belongs to its right side.
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

  /// First and last value of a node; both 0 without nodes.
  double FirstValue() const;
  double LastValue() const;

  /// The values between which the look changes; none if it is the same for all. Beyond the ends all
  /// values look alike. Colours do not count where the opacity is 0.
  std::optional<ValueRange> ChangingValues() const;

  /// The jumps of the curves of colour and opacity, ascending by value.
  std::vector<Step> Steps() const;

  /// True if the curve of colour or opacity jumps anywhere, or at a value.
  bool HasStep() const;
  bool HasStepAt(double value) const;

  /// True if all curves between nodes are straight and there is no step.
  bool IsPiecewiseLinear() const;

  /// The values of all nodes, ascending and without duplicates.
  std::vector<double> NodeValues() const;

  /// Smallest distance between two nodes that are not the sides of a step; infinite if there are
  /// none.
  double SmallestNodeGap() const;

  const std::vector<ColorNode>& Colors() const { return this->colors; }
  const std::vector<OpacityNode>& Opacities() const { return this->opacities; }
  double OpacityUnitDistanceMm() const { return this->opacityUnitDistanceMm; }

private:
  std::vector<ColorNode> colors;
  std::vector<OpacityNode> opacities;
  double opacityUnitDistanceMm;
};

}

#endif
