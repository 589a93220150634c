#ifndef Varimarch_Testing_Unit_OpacityCurve_h
#define Varimarch_Testing_Unit_OpacityCurve_h

#include "Core/Look/TransferFunction.h"

#include <utility>
#include <vector>

namespace varimarch
{

/// A white transfer function of these opacities.
inline TransferFunction OpacityCurve(std::vector<OpacityNode> nodes, double unitDistanceMm = 1.0)
{
  return TransferFunction({}, std::move(nodes), unitDistanceMm);
}

}

#endif
