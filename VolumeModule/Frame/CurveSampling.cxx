#include "Frame/CurveSampling.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

// The distance of straight pieces from the curve, far below the resolution of a display.
constexpr double Deviation = 1.0 / 20000.0;

// The pieces between two nodes in which every curve is examined, so that none of its waves is
// missed.
constexpr int FewestPieces = 16;

// A piece is halved so often before the difference of its ends counts as a jump.
constexpr int MostHalvings = 16;

double DistanceOf(const glm::dvec3& one, const glm::dvec3& other)
{
  const glm::dvec3 apart = glm::abs(one - other);
  return std::max({ apart.r, apart.g, apart.b });
}

// Appends nodes behind one of a curve up to the next.
class CurveFollower
{
public:
  CurveFollower(const ColorCurve& curve, CurveScale scale, std::vector<ColorNode>& nodes)
    : curve(curve)
    , scale(scale)
    , nodes(nodes)
  {
  }

  ColorNode Between(const ColorNode& left, const ColorNode& right, double fraction) const
  {
    return this->At(this->scale == CurveScale::Linear
        ? glm::mix(left.value, right.value, fraction)
        : left.value * std::pow(right.value / left.value, fraction));
  }

  void Append(const ColorNode& left, const ColorNode& right, int halvings) const
  {
    const ColorNode middle = this->Between(left, right, 0.5);
    if (!(left.value < middle.value && middle.value < right.value) ||
      this->IsStraight(left, middle, right))
    {
      this->nodes.push_back(right);
    }
    else if (halvings == 0)
    {
      this->AppendJump(left, right);
    }
    else
    {
      this->Append(left, middle, halvings - 1);
      this->Append(middle, right, halvings - 1);
    }
  }

private:
  ColorNode At(double value) const { return { value, glm::clamp(this->curve(value), 0.0, 1.0) }; }

  bool IsStraight(const ColorNode& left, const ColorNode& middle, const ColorNode& right) const
  {
    const auto isOnPiece = [&](const ColorNode& node)
    {
      const double fraction = (node.value - left.value) / (right.value - left.value);
      return DistanceOf(node.rgb, glm::mix(left.rgb, right.rgb, fraction)) <= Deviation;
    };
    return isOnPiece(middle) && isOnPiece(this->Between(left, right, 0.25)) &&
      isOnPiece(this->Between(left, right, 0.75));
  }

  // The value of a jump at the left end of the piece, where the curve has a node, belongs to the
  // left side; that of any other to the right side.
  void AppendJump(const ColorNode& left, const ColorNode& right) const
  {
    constexpr int MostBisections = 128;
    ColorNode before = left;
    ColorNode behind = right;
    for (int i = 0; i < MostBisections && !AreSidesOfStep(before.value, behind.value); ++i)
    {
      const ColorNode middle = this->At(0.5 * before.value + 0.5 * behind.value);
      const bool isBefore = DistanceOf(middle.rgb, before.rgb) < DistanceOf(middle.rgb, behind.rgb);
      (isBefore ? before : behind) = middle;
    }
    if (before.value == left.value)
    {
      this->nodes.push_back({ left.value, behind.rgb });
    }
    else
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      this->nodes.push_back({ std::nextafter(behind.value, -infinity), before.rgb });
      this->nodes.push_back(behind);
    }
    if (behind.value < right.value)
    {
      this->nodes.push_back(right);
    }
  }

  const ColorCurve& curve;
  CurveScale scale;
  std::vector<ColorNode>& nodes;
};

// True if a node lies on the straight piece between its neighbours, as many do beside a jump.
bool IsNeedless(const ColorNode& left, const ColorNode& node, const ColorNode& right)
{
  constexpr double Rounding = 1e-9;
  const double fraction = (node.value - left.value) / (right.value - left.value);
  return !AreSidesOfStep(left.value, node.value) && !AreSidesOfStep(node.value, right.value) &&
    DistanceOf(node.rgb, glm::mix(left.rgb, right.rgb, fraction)) <= Rounding;
}

void AppendWithoutNeedless(const std::vector<ColorNode>& followed, std::vector<ColorNode>& nodes)
{
  const std::size_t first = nodes.size();
  for (const ColorNode& node : followed)
  {
    while (nodes.size() > first + 1 && IsNeedless(nodes[nodes.size() - 2], nodes.back(), node))
    {
      nodes.pop_back();
    }
    nodes.push_back(node);
  }
}

}

void Follow(
  const ColorCurve& curve, const ColorNode& end, CurveScale scale, std::vector<ColorNode>& nodes)
{
  const ColorNode begin = nodes.back();
  std::vector<ColorNode> followed = { begin };
  const CurveFollower follower(curve, scale, followed);
  ColorNode left = begin;
  for (int piece = 1; piece <= FewestPieces; ++piece)
  {
    const ColorNode right =
      piece < FewestPieces ? follower.Between(begin, end, double(piece) / FewestPieces) : end;
    follower.Append(left, right, MostHalvings);
    left = right;
  }
  nodes.pop_back();
  AppendWithoutNeedless(followed, nodes);
}

}
