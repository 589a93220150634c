#include "Support/AnalyticScenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Composites a part a of a ray over the part b behind it.
glm::dvec4 Over(glm::dvec4 a, glm::dvec4 b)
{
  return a + (1.0 - a.a) * b;
}

/// Mean of exp(-(front u + (back - front) u^2 / 2)) over u in [0, 1], by a Taylor series whose
/// terms follow from y' = -(front + (back - front) u) y. Accurate for depths up to about 1.
double MeanTransmittance(double frontDepth, double backDepth)
{
  double before = 0.0;
  double term = 1.0;
  double sum = 1.0;
  constexpr int terms = 40;
  for (int k = 0; k < terms; ++k)
  {
    const double next = -(frontDepth * term + (backDepth - frontDepth) * before) / (k + 1.0);
    before = term;
    term = next;
    sum += term / (k + 2.0);
  }
  return sum;
}

OpticalProperties Middle(const OpticalProperties& a, const OpticalProperties& b)
{
  return { 0.5 * (a.rgb + b.rgb), 0.5 * (a.extinction + b.extinction) };
}

/// Sorts numbers and removes duplicates.
std::vector<double> Sorted(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Interpolates linearly between voxels along one axis; constant beyond the ends.
double ValueAt(const std::vector<double>& values, double position)
{
  const double inside = std::clamp(position, 0.0, double(values.size() - 1));
  const std::size_t lower = std::min(std::size_t(inside), values.size() - 1);
  const std::size_t upper = std::min(lower + 1, values.size() - 1);
  return values[lower] + (values[upper] - values[lower]) * (inside - double(lower));
}

double ValueAt(const AnalyticScene& scene, glm::dvec3 position)
{
  return ValueAt(scene.values[0], position.x) + ValueAt(scene.values[1], position.y) +
    ValueAt(scene.values[2], position.z);
}

/// Ray parameters of cell faces, entry and exit.
std::vector<double> FacesAlong(const AnalyticScene& scene, const MeasuredRay& ray)
{
  const Interval inside = ray.parts.front(); // scenes with a closed form have no cuts
  std::vector<double> faces = { inside.enter, inside.exit };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t face = 0; face < scene.values[axis].size(); ++face)
    {
      const double t = (double(face) - ray.grid.origin[axis]) / ray.grid.direction[axis];
      if (t > inside.enter && t < inside.exit)
      {
        faces.push_back(t);
      }
    }
  }
  return Sorted(faces);
}

/// Colour of a part of a ray without nodes inside, along which the value is linear.
glm::dvec4 StretchColor(
  const TransferFunction& transferFunction, double first, double last, double lengthMm)
{
  // The function may step at the ends, so extrapolate its properties from the inside.
  const auto inside = [&](double part) -> OpticalProperties
  {
    const double value = first + part * (last - first);
    return { transferFunction.Color(value), transferFunction.Extinction(value) };
  };
  const OpticalProperties near = inside(0.25);
  const OpticalProperties far = inside(0.75);
  if (std::isinf(near.extinction))
  {
    return { 1.5 * near.rgb - 0.5 * far.rgb, 1.0 };
  }
  return LinearPieceColor(
    { 1.5 * near.rgb - 0.5 * far.rgb, 1.5 * near.extinction - 0.5 * far.extinction },
    { 1.5 * far.rgb - 0.5 * near.rgb, 1.5 * far.extinction - 0.5 * near.extinction }, lengthMm);
}

/// Colour of the part of a ray in one cell, split at the nodes.
glm::dvec4 CellColor(
  const TransferFunction& transferFunction, double first, double last, double lengthMm)
{
  if (first == last)
  {
    return StretchColor(transferFunction, first, last, lengthMm);
  }
  std::vector<double> cuts = { 0.0, 1.0 };
  const auto cut = [&](double value)
  {
    const double part = (value - first) / (last - first);
    if (part > 0.0 && part < 1.0)
    {
      cuts.push_back(part);
    }
  };
  for (const ColorNode& node : transferFunction.Colors())
  {
    cut(node.value);
  }
  for (const OpacityNode& node : transferFunction.Opacities())
  {
    cut(node.value);
  }
  cuts = Sorted(cuts);
  glm::dvec4 sum(0.0);
  const auto valueAt = [&](double part) { return first + part * (last - first); };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    sum = Over(sum,
      StretchColor(transferFunction, valueAt(cuts[i]), valueAt(cuts[i + 1]),
        (cuts[i + 1] - cuts[i]) * lengthMm));
  }
  return sum;
}

}

// Integration by parts: the integral of c sigma T is c_front - c_back T + (c_back - c_front) times
// the mean of T.
glm::dvec4 LinearPieceColor(
  const OpticalProperties& front, const OpticalProperties& back, double lengthMm)
{
  if (std::max(front.extinction, back.extinction) * lengthMm > 1.0 && front.rgb != back.rgb)
  {
    const OpticalProperties middle = Middle(front, back);
    return Over(LinearPieceColor(front, middle, 0.5 * lengthMm),
      LinearPieceColor(middle, back, 0.5 * lengthMm));
  }
  const double alpha = -std::expm1(-0.5 * (front.extinction + back.extinction) * lengthMm);
  if (front.rgb == back.rgb)
  {
    return { alpha * front.rgb, alpha };
  }
  const double mean = MeanTransmittance(front.extinction * lengthMm, back.extinction * lengthMm);
  return { front.rgb - (1.0 - alpha) * back.rgb + mean * (back.rgb - front.rgb), alpha };
}

glm::ivec3 AnalyticScene::Dimensions() const
{
  return { int(this->values[0].size()), int(this->values[1].size()), int(this->values[2].size()) };
}

std::vector<double> AnalyticScene::Voxels() const
{
  std::vector<double> voxels;
  for (const double z : this->values[2])
  {
    for (const double y : this->values[1])
    {
      for (const double x : this->values[0])
      {
        voxels.push_back(x + y + z);
      }
    }
  }
  return voxels;
}

glm::dvec4 AnalyticScene::Color(const MeasuredRay& ray) const
{
  const std::vector<double> faces = FacesAlong(*this, ray);
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    sum = Over(sum,
      CellColor(this->transferFunction, ValueAt(*this, ray.PositionGrid(faces[i])),
        ValueAt(*this, ray.PositionGrid(faces[i + 1])),
        (faces[i + 1] - faces[i]) * ray.mmPerParameter));
  }
  return sum;
}

std::vector<float> AnalyticScene::Picture(const ReferenceView& view) const
{
  std::vector<float> picture;
  for (int row = 0; row < view.height; ++row)
  {
    for (int column = 0; column < view.width; ++column)
    {
      const Ray ray = view.rays.At(
        2.0 * (column + 0.5) / view.width - 1.0, 2.0 * (row + 0.5) / view.height - 1.0);
      const Interval inside = Intersection(ray, this->BoxGrid(), view.rays.BetweenPlanes(ray));
      const glm::dvec4 color = inside.IsEmpty()
        ? glm::dvec4(0.0)
        : this->Color(
            { ray, glm::length(view.worldFromGridDirection * ray.direction), { inside } });
      for (int channel = 0; channel < 4; ++channel)
      {
        picture.push_back(float(color[channel]));
      }
    }
  }
  return picture;
}

namespace
{

// For so small a distance, opacity equals extinction times distance up to a relative 1e-12.
constexpr double UnitDistanceMm = 1e-12;

OpacityNode ExtinctionNode(double value, double extinction)
{
  return { value, -std::expm1(-extinction * UnitDistanceMm) };
}

const glm::dvec3 orange(1.0, 0.5, 0.1);
const glm::dvec3 teal(0.1, 0.6, 0.7);

/// The numbers i * step for i in [0, count).
std::vector<double> Ramp(int count, double step)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(i * step);
  }
  return values;
}

/// Squared distances from the middle one of `count` voxels, an odd number.
std::vector<double> Squares(int count)
{
  std::vector<double> values;
  for (int i = -count / 2; i <= count / 2; ++i)
  {
    values.push_back(double(i) * i);
  }
  return values;
}

/// A field that rises from 0 to 64 in an oblique direction.
AnalyticScene Oblique(std::string name, TransferFunction transferFunction)
{
  return { std::move(name), { Ramp(9, 4.0), Ramp(13, 1.0), Ramp(11, 2.0) }, { 1.25, 0.75, 1.0 },
    std::move(transferFunction) };
}

/// A field of squared distances, in voxels, from the centre of the volume.
AnalyticScene Round(std::string name, TransferFunction transferFunction)
{
  return { std::move(name), { Squares(17), Squares(17), Squares(17) }, glm::dvec3(1.0),
    std::move(transferFunction) };
}

/// Linear pieces of extinction(value) and colour from 0 to `last`.
TransferFunction Sampled(double last, int pieces, double (*extinction)(double))
{
  std::vector<OpacityNode> nodes;
  for (int i = 0; i <= pieces; ++i)
  {
    const double value = last * i / pieces;
    nodes.push_back(ExtinctionNode(value, extinction(value)));
  }
  return { { { 0.0, orange }, { last, teal } }, nodes, UnitDistanceMm };
}

}

std::vector<AnalyticScene> AnalyticScenes()
{
  const double interface = 64.0 / std::exp(1.0); // not at any voxel
  const double radius2 = 7.1 * 7.1, thickness2 = 0.5;
  const std::vector<ColorNode> twoColors = { { 0.0, orange }, { 64.0, teal } };
  const auto constant = [](std::vector<ColorNode> colors, double before, double at, double behind)
  {
    return TransferFunction(std::move(colors),
      { ExtinctionNode(at, before), ExtinctionNode(at, behind) }, UnitDistanceMm);
  };
  return {
    { "constant slab", { Ramp(4, 0.0), Ramp(3, 0.0), Ramp(5, 0.0) }, { 1.0, 2.0, 0.5 },
      { { { 0.0, orange } }, { ExtinctionNode(0.0, 0.3) }, UnitDistanceMm } },
    Oblique("linear ramp",
      { twoColors, { ExtinctionNode(0.0, 0.0), ExtinctionNode(64.0, 0.5) }, UnitDistanceMm }),
    Oblique("exponential", Sampled(64.0, 40, [](double v) { return 0.8 * std::exp(-v / 12.0); })),
    Oblique(
      "two media", constant({ { interface, orange }, { interface, teal } }, 0.05, interface, 0.7)),
    Oblique("veil before a wall",
      { { { interface, orange }, { interface, teal }, { 64.0, orange } },
        { ExtinctionNode(interface, 1e-3), { interface, 1.0 } }, UnitDistanceMm }),
    Round("ball", constant({ { 0.0, orange }, { 64.0, teal } }, 0.2, radius2, 0.0)),
    Round("Gaussian ball", Sampled(192.0, 60, [](double v) { return 0.5 * std::exp(-v / 18.0); })),
    Round("thin shell",
      { twoColors,
        { ExtinctionNode(radius2 - thickness2, 0.0), ExtinctionNode(radius2, 20.0),
          ExtinctionNode(radius2 + thickness2, 0.0) },
        UnitDistanceMm }),
  };
}

}
