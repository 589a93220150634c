#include "Scene/Model/SceneChange.h"

#include "Core/Look/TransferFunction.h"
#include "Scene/Model/SceneCuts.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

// Samples between two nodes whose curve is not straight.
constexpr int SamplesOfCurve = 16;

// One look of a change.
struct Side
{
  Side(const Look& look, double unitDistanceMm)
    : function(look.colors, look.opacities, look.opacityUnitDistanceMm)
    , byGradient({}, look.gradientOpacities, 1.0)
    , hasGradient(!look.gradientOpacities.empty())
    , unitDistances(unitDistanceMm / look.opacityUnitDistanceMm)
  {
  }

  /// The opacity over the unit distance of the change.
  double Opacity(double value) const
  {
    return 1.0 - std::pow(1.0 - this->function.Opacity(value), this->unitDistances);
  }

  double FactorOfGradient(double gradient) const
  {
    return this->hasGradient ? this->byGradient.Opacity(gradient) : 1.0;
  }

  TransferFunction function;
  TransferFunction byGradient;
  bool hasGradient;
  double unitDistances;
};

// A node of a mixed curve, and the value at which the two curves are read for it.
struct Sample
{
  double node;
  double value;
};

// The samples of two curves, ascending. A step, which belongs to its left side, has two at one
// node.
std::vector<Sample> Samples(const TransferFunction& a, const TransferFunction& b)
{
  std::vector<double> nodes = a.NodeValues();
  const std::vector<double> others = b.NodeValues();
  nodes.insert(nodes.end(), others.begin(), others.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const bool areStraight = a.IsPiecewiseLinear() && b.IsPiecewiseLinear() &&
    a.OpacityUnitDistanceMm() == b.OpacityUnitDistanceMm();
  const int parts = areStraight ? 1 : SamplesOfCurve;
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    samples.push_back({ nodes[i], nodes[i] });
    if (a.HasStepAt(nodes[i]) || b.HasStepAt(nodes[i]))
    {
      samples.push_back({ nodes[i], std::nextafter(nodes[i], std::numeric_limits<double>::max()) });
    }
    for (int step = 1; step < parts && i + 1 < nodes.size(); ++step)
    {
      const double between = glm::mix(nodes[i], nodes[i + 1], double(step) / parts);
      samples.push_back({ between, between });
    }
  }
  return samples;
}

// Light that does not depend on a surface is ambient.
Shading AsShading(const Look& look)
{
  return look.shading.enabled ? look.shading : Shading{ true, 1.0, 0.0, 0.0, 1.0 };
}

Shading Mixed(const Shading& from, const Shading& to, double part)
{
  return { true, glm::mix(from.ambient, to.ambient, part), glm::mix(from.diffuse, to.diffuse, part),
    glm::mix(from.specular, to.specular, part),
    glm::mix(from.specularPower, to.specularPower, part) };
}

void MixCurves(const Side& from, const Side& to, double part, Look& mixed)
{
  mixed.colors.clear();
  mixed.opacities.clear();
  for (const auto& [node, value] : Samples(from.function, to.function))
  {
    const double ofFrom = (1.0 - part) * from.Opacity(value);
    const double ofTo = part * to.Opacity(value);
    const double weight = ofFrom + ofTo > 0.0 ? ofTo / (ofFrom + ofTo) : part;
    mixed.colors.push_back(
      { node, glm::mix(from.function.Color(value), to.function.Color(value), weight) });
    mixed.opacities.push_back({ node, ofFrom + ofTo });
  }
}

}

SceneCuts CutsOnTheirWay(const SceneCuts& cuts, vtkImageData* image, double part)
{
  SceneCuts moved = cuts;
  const SceneCuts none;
  std::transform(none.box.begin(), none.box.end(), cuts.box.begin(), moved.box.begin(),
    [part](double outside, double place) { return glm::mix(outside, place, part); });
  for (CutPlane& plane : moved.planes)
  {
    plane = AtDepth(part * DepthOf(plane, image), plane, image);
  }
  return moved;
}

bool CanChange(const Look& from, const Look& to)
{
  const auto isPlain = [](const Look& look)
  { return look.blend == Blend::Composite && look.regions.empty(); };
  return isPlain(from) && isPlain(to);
}

Look LookBetween(const Look& from, const Look& to, double part)
{
  Look mixed = to;
  const Side sides[] = { { from, to.opacityUnitDistanceMm }, { to, to.opacityUnitDistanceMm } };
  MixCurves(sides[0], sides[1], part, mixed);
  if (sides[0].hasGradient || sides[1].hasGradient)
  {
    mixed.gradientOpacities.clear();
    for (const auto& [node, gradient] : Samples(sides[0].byGradient, sides[1].byGradient))
    {
      mixed.gradientOpacities.push_back({ node,
        glm::mix(sides[0].FactorOfGradient(gradient), sides[1].FactorOfGradient(gradient), part) });
    }
  }
  if (from.shading.enabled || to.shading.enabled)
  {
    mixed.shading = Mixed(AsShading(from), AsShading(to), part);
  }
  mixed.dampingGradient = glm::mix(from.dampingGradient, to.dampingGradient, part);
  return mixed;
}

}
