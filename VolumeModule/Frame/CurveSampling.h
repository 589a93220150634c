#ifndef Varimarch_Frame_CurveSampling_h
#define Varimarch_Frame_CurveSampling_h

#include "Core/Look/TransferFunction.h"

#include <functional>
#include <vector>

namespace varimarch
{

/// A colour at each value.
using ColorCurve = std::function<glm::dvec3(double value)>;

/// How values between two others are spread: evenly, or evenly in their logarithm.
enum class CurveScale
{
  Linear,
  Logarithmic,
};

/// Appends nodes that follow a curve from the last of `nodes` to another node, by straight pieces
/// whose distance from the curve is at most 1/20000 in [0, 1]. A jump of the curve becomes a step.
/// @param curve  it may leave [0, 1], to which the nodes are limited
/// @param nodes  at least one; its last has the value of the curve there
/// @param scale  the scale on which the curve is about as smooth everywhere
void Follow(
  const ColorCurve& curve, const ColorNode& end, CurveScale scale, std::vector<ColorNode>& nodes);

}

#endif
