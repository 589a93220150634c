#include "Module/Scenes/SliceTruth.h"

#include "Core/Geometry/PixelRays.h"
#include "Frame/PropertyTransferFunction.h"
#include "Module/Scenes/ReferenceMaterials.h"

#include <vtkImplicitFunction.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// The roots of a function of second degree in an interval, ascending.
template <class Function>
std::vector<double> RootsIn(const Interval& inside, const Function& function)
{
  const double middle = 0.5 * (inside.enter + inside.exit);
  const double half = 0.5 * (inside.exit - inside.enter);
  const double c = function(middle);
  const double after = function(inside.exit);
  const double before = function(inside.enter);
  const double b = 0.5 * (after - before);
  const double a = 0.5 * (after + before) - c;
  std::vector<double> roots;
  const double square = b * b - 4.0 * a * c;
  // Values of a plane are linear but for rounding.
  if (std::abs(a) < 1e-12 * (std::abs(b) + std::abs(c)))
  {
    roots = { -c / b };
  }
  else if (square > 0.0)
  {
    const double larger = -0.5 * (b + std::copysign(std::sqrt(square), b));
    roots = { larger / a, c / larger };
  }
  std::sort(roots.begin(), roots.end());
  std::vector<double> places;
  for (const double root : roots)
  {
    if (std::abs(root) <= 1.0)
    {
      places.push_back(middle + root * half);
    }
  }
  return places;
}

// Colour of a ray: the values on the slice from front to back.
glm::dvec4 ColorOf(MapperScene& scene, const SceneSamples& samples, const Ray& ray, Interval inside)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  const TransferFunction function = TransferFunctionOf(property);
  const auto positionAt = [&](double t) { return ray.origin + t * ray.direction; };
  const auto sliceAt = [&](double t)
  {
    const glm::dvec3 world = samples.PositionWorld(positionAt(t));
    return property->GetSliceFunction()->FunctionValue(world.x, world.y, world.z);
  };
  glm::dvec4 sum(0.0);
  for (const double t : RootsIn(inside, sliceAt))
  {
    const double value = samples.Value(positionAt(t));
    const double opacity = function.Opacity(value);
    sum += (1.0 - sum.a) * opacity * glm::dvec4(function.Color(value), 1.0);
  }
  return sum;
}

}

std::vector<float> SliceTruth(MapperScene& scene)
{
  const VolumeGeometry geometry = VolumeGeometryOf(scene.image, scene.volume);
  const PixelRays rays =
    ComputePixelRays(ClipFromWorld(scene.renderer) * geometry.worldFromGrid, geometry.boxGrid);
  const SceneSamples samples(scene);
  std::vector<float> rgba;
  for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
  {
    const Ray ray = rays.At(2.0 * (pixel % scene.size + 0.5) / scene.size - 1.0,
      2.0 * (pixel / scene.size + 0.5) / scene.size - 1.0);
    const Interval inside = Intersection(ray, geometry.boxGrid, rays.BetweenPlanes(ray));
    const glm::dvec4 color =
      inside.IsEmpty() ? glm::dvec4(0.0) : ColorOf(scene, samples, ray, inside);
    rgba.insert(rgba.end(), { float(color.r), float(color.g), float(color.b), float(color.a) });
  }
  return rgba;
}
