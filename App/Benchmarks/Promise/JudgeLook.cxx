#include "JudgeScene.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

void MakeSorted(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The nodes of a function and the midpoints between them, where a curve with a sharpness jumps.
template <class Function>
std::vector<double> NodesOf(Function* function)
{
  std::vector<double> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // VTK writes four numbers for a piecewise function, six for a colour function
    function->GetNodeValue(i, node);
    nodes.push_back(node[0]);
    const bool isOfColor = std::is_same_v<Function, vtkColorTransferFunction>;
    const double midpoint = node[isOfColor ? 4 : 2];
    if (i + 1 < function->GetSize())
    {
      double next[6];
      function->GetNodeValue(i + 1, next);
      nodes.push_back(node[0] + midpoint * (next[0] - node[0]));
    }
  }
  MakeSorted(nodes);
  return nodes;
}

void SetColor(JudgeFunctions& functions, vtkColorTransferFunction* color)
{
  functions.colorNodes = NodesOf(color);
  functions.color = [color = vtkSmartPointer<vtkColorTransferFunction>(color)](double value)
  {
    glm::dvec3 rgb;
    color->GetColor(value, &rgb[0]);
    return glm::clamp(rgb, 0.0, 1.0);
  };
}

double Clamped(double value)
{
  return std::clamp(value, 0.0, 1.0);
}

glm::dvec3 Clamped(glm::dvec3 value)
{
  return glm::clamp(value, 0.0, 1.0);
}

double LargestOf(double value)
{
  return std::abs(value);
}

double LargestOf(glm::dvec3 value)
{
  return std::max({ std::abs(value.x), std::abs(value.y), std::abs(value.z) });
}

// Finds the limits of a function at both ends of an interval if it is straight there.
template <class Value, class Function>
bool FindEnds(const Function& function, double lower, double upper, Value* ends)
{
  constexpr double Rounding = 1e-12;
  const auto at = [&](double part) { return function(lower + part * (upper - lower)); };
  const Value first = at(0.25);
  const Value slope = 2.0 * (at(0.75) - first);
  ends[0] = Clamped(first - 0.25 * slope);
  ends[1] = Clamped(first + 0.75 * slope);
  bool isStraight = true;
  for (const double part : { 0.0625, 0.125, 0.4375, 0.5, 0.625, 0.9375 })
  {
    isStraight = isStraight && LargestOf(at(part) - (first + (part - 0.25) * slope)) < Rounding;
  }
  return isStraight;
}

}

JudgeFunctions FunctionsOf(vtkVolumeProperty* property, int component)
{
  JudgeFunctions functions;
  functions.opacity = property->GetScalarOpacity(component);
  functions.unitDistanceMm = property->GetScalarOpacityUnitDistance(component);
  if (property->HasGradientOpacity(component))
  {
    functions.gradientOpacity = property->GetGradientOpacity(component);
  }
  if (property->GetColorChannels(component) == 3)
  {
    SetColor(functions, property->GetRGBTransferFunction(component));
    return functions;
  }
  const vtkSmartPointer<vtkPiecewiseFunction> gray = property->GetGrayTransferFunction(component);
  functions.colorNodes = NodesOf(gray.Get());
  functions.color = [gray](double value) { return glm::dvec3(Clamped(gray->GetValue(value))); };
  return functions;
}

JudgeFunctions LabelFunctionsOf(vtkVolumeProperty* property, int label)
{
  JudgeFunctions functions = FunctionsOf(property, 0);
  if (vtkPiecewiseFunction* const opacity = property->GetLabelScalarOpacity(label))
  {
    functions.opacity = opacity;
  }
  if (vtkColorTransferFunction* const color = property->GetLabelColor(label))
  {
    SetColor(functions, color);
  }
  return functions;
}

JudgeLook::JudgeLook(JudgeFunctions given)
  : functions(std::move(given))
{
  this->nodes = NodesOf(this->functions.opacity.Get());
  this->nodes.insert(
    this->nodes.end(), this->functions.colorNodes.begin(), this->functions.colorNodes.end());
  MakeSorted(this->nodes);
  double lower = -Infinite;
  for (const double node : this->nodes)
  {
    this->bands.push_back(this->BandBetween(lower, node));
    lower = node;
  }
  this->bands.push_back(this->BandBetween(lower, Infinite));
  if (this->functions.gradientOpacity)
  {
    this->gradientNodes = NodesOf(this->functions.gradientOpacity.Get());
  }
}

JudgeLook::Band JudgeLook::BandBetween(double lower, double upper) const
{
  // Functions are constant beyond their nodes.
  const double below = std::isfinite(lower)
    ? lower
    : (std::isfinite(upper) ? upper - 2.0 * std::max(1.0, std::abs(upper)) : 0.0);
  const double above = std::isfinite(upper) ? upper : below + 2.0 * std::max(1.0, std::abs(below));
  Band band{ lower, upper, false, false, {}, {}, false };
  const auto opacity = [this](double value)
  { return Clamped(this->functions.opacity->GetValue(value)); };
  band.opacityIsStraight = FindEnds(opacity, below, above, band.opacities);
  band.colorIsStraight = FindEnds(this->functions.color, below, above, band.colors);
  band.isInvisible = band.opacityIsStraight && band.opacities[0] == 0.0 && band.opacities[1] == 0.0;
  return band;
}

int JudgeLook::BandOf(double value) const
{
  return int(std::upper_bound(this->nodes.begin(), this->nodes.end(), value) - this->nodes.begin());
}

bool JudgeLook::MayBeVisible(double lower, double upper) const
{
  const int last = this->BandOf(upper);
  for (int band = this->BandOf(lower); band <= last; ++band)
  {
    if (!(*this)[band].isInvisible)
    {
      return true;
    }
  }
  return false;
}

namespace
{

// The part of the way through a band at which a value lies.
double PartOf(const JudgeLook::Band& band, double value)
{
  return std::isfinite(band.lower) && std::isfinite(band.upper)
    ? std::clamp((value - band.lower) / (band.upper - band.lower), 0.0, 1.0)
    : 0.0;
}

}

double JudgeLook::Opacity(const Band& band, double value) const
{
  return band.opacityIsStraight
    ? glm::mix(band.opacities[0], band.opacities[1], PartOf(band, value))
    : Clamped(this->functions.opacity->GetValue(value));
}

glm::dvec3 JudgeLook::Color(const Band& band, double value) const
{
  return band.colorIsStraight ? glm::mix(band.colors[0], band.colors[1], PartOf(band, value))
                              : this->functions.color(value);
}

double JudgeLook::GradientFactor(double magnitude) const
{
  return this->functions.gradientOpacity
    ? Clamped(this->functions.gradientOpacity->GetValue(magnitude))
    : 1.0;
}

double JudgeLook::Extinction(double opacity, double mostPerMm) const
{
  return std::min(-std::log1p(-opacity) / this->functions.unitDistanceMm, mostPerMm);
}

}
