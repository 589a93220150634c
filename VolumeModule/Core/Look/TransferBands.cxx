#include "Core/Look/TransferBands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Node>
void AppendCuts(const std::vector<Node>& nodes, std::vector<double>& cuts)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    cuts.push_back(nodes[i].value);
    const NodeShape& shape = nodes[i].shape;
    if (i + 1 < nodes.size() && (shape.midpoint != 0.5 || shape.sharpness != 0.0))
    {
      cuts.push_back(HalfWayValue(nodes[i].value, nodes[i + 1].value, shape));
    }
  }
}

}

TransferBands::TransferBands(
  const TransferFunction& transferFunction, const std::vector<double>& moreCuts)
  : transferFunction(transferFunction)
  , cuts(moreCuts)
{
  AppendCuts(transferFunction.Colors(), this->cuts);
  AppendCuts(transferFunction.Opacities(), this->cuts);
  std::sort(this->cuts.begin(), this->cuts.end());
  this->cuts.erase(std::unique(this->cuts.begin(), this->cuts.end()), this->cuts.end());

  this->visibleBefore.push_back(0);
  for (std::size_t i = 0; i <= this->cuts.size(); ++i)
  {
    const double lower = i > 0 ? this->cuts[i - 1] : -infinity;
    const double upper = i < this->cuts.size() ? this->cuts[i] : infinity;
    this->bands.push_back({ lower, upper, this->KindOf(lower, upper) });
    const bool visible = this->bands.back().kind != Kind::Invisible;
    this->visibleBefore.push_back(this->visibleBefore.back() + visible);
  }
}

TransferBands::Kind TransferBands::KindOf(double lower, double upper) const
{
  // Curves are monotone in a band, so equal values at both ends mean equal values in between. The
  // ends are a bit inside, because a step at an end belongs to one side only.
  const bool endless = lower == -infinity || upper == infinity;
  const double nearLower =
    endless ? (upper == infinity ? upper : lower) : std::nextafter(lower, infinity);
  const double nearUpper = endless ? nearLower : std::nextafter(upper, -infinity);
  // The opacity of a thin veil beside an opaque node rounds to 1, its extinction is finite.
  const double extinction = this->transferFunction.Extinction(nearLower);
  if (extinction != this->transferFunction.Extinction(nearUpper))
  {
    return Kind::Varying;
  }
  if (extinction == 0.0)
  {
    return Kind::Invisible;
  }
  if (std::isinf(extinction))
  {
    return Kind::Opaque;
  }
  const bool oneColor =
    this->transferFunction.Color(nearLower) == this->transferFunction.Color(nearUpper);
  return oneColor ? Kind::Constant : Kind::Varying;
}

int TransferBands::BandBelow(double value) const
{
  return int(std::lower_bound(this->cuts.begin(), this->cuts.end(), value) - this->cuts.begin());
}

int TransferBands::BandAbove(double value) const
{
  return int(std::upper_bound(this->cuts.begin(), this->cuts.end(), value) - this->cuts.begin());
}

bool TransferBands::MayBeVisible(double lowest, double highest) const
{
  return this->visibleBefore[this->BandBelow(highest) + 1] >
    this->visibleBefore[this->BandBelow(lowest)];
}

TransferBands::Band TransferBands::OnlyAt(double value) const
{
  const double extinction = this->transferFunction.Extinction(value);
  const Kind kind = extinction == 0.0 ? Kind::Invisible
    : std::isinf(extinction)          ? Kind::Opaque
                                      : Kind::Constant;
  return { std::nextafter(value, -infinity), std::nextafter(value, infinity), kind };
}

double TransferBands::Band::Kept(double value) const
{
  // std::clamp does not apply: in a band one bit wide the lower limit exceeds the upper one.
  return std::min(
    std::max(value, std::nextafter(this->lower, infinity)), std::nextafter(this->upper, -infinity));
}

OpticalProperties TransferBands::Inside(const Band& band, double value) const
{
  const double kept = band.Kept(value);
  return { this->transferFunction.Color(kept), this->transferFunction.Extinction(kept) };
}

}
