#include "Scene/Looks/LookRegions.h"

#include "Scene/Looks/VolumeProperty.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

// All relevant versions of OpenGL guarantee buffer textures of their product.
constexpr int TableValues = 512;
constexpr int TableGradients = 128;

// Keeps quotients numbers where a look was stretched to nothing, as on a constant volume.
constexpr double LeastWidth = std::numeric_limits<double>::min();

/// Distance from the middle of an interval in units of half its width.
double PlaceInInterval(const std::array<double, 2>& interval, double number)
{
  const double middle = 0.5 * interval[0] + 0.5 * interval[1];
  return std::abs(number - middle) / std::max(interval[1] - middle, LeastWidth);
}

std::array<double, 2> FiniteRangeOf(vtkImageData* image)
{
  std::array<double, 2> range;
  image->GetPointData()->GetScalars()->GetFiniteRange(range.data(), 0);
  return range;
}

/// The opacity of a region at a place, which falls linearly at a soft edge.
double OpacityAt(const LookRegion& region, double place)
{
  if (place >= 1.0)
  {
    return 0.0;
  }
  return region.opacity * std::min((1.0 - place) / std::max(region.softness, LeastWidth), 1.0);
}

}

double PlaceInRegion(const LookRegion& region, double value, double gradient)
{
  const double alongValues = PlaceInInterval(region.values, value);
  if (region.shape == RegionShape::Ellipse)
  {
    return std::hypot(alongValues, PlaceInInterval(region.gradients, gradient));
  }
  const bool reachesZero = region.gradients[0] <= 0.0;
  return std::max(alongValues,
    reachesZero ? gradient / std::max(region.gradients[1], LeastWidth)
                : PlaceInInterval(region.gradients, gradient));
}

glm::dvec4 ColorInRegions(const std::vector<LookRegion>& regions, double value, double gradient)
{
  glm::dvec3 emission(0.0);
  double opacity = 0.0;
  glm::dvec3 nearest(0.0);
  double nearestPlace = std::numeric_limits<double>::infinity();
  for (const LookRegion& region : regions)
  {
    const double place = PlaceInRegion(region, value, gradient);
    const double own = OpacityAt(region, place);
    emission = own * region.rgb + (1.0 - own) * emission;
    opacity = own + (1.0 - own) * opacity;
    if (place < nearestPlace)
    {
      nearest = region.rgb;
      nearestPlace = place;
    }
  }
  return { opacity > 0.0 ? emission / opacity : nearest, opacity };
}

std::vector<LookRegion> TransformedRegions(
  std::vector<LookRegion> regions, double factor, double offset)
{
  for (LookRegion& region : regions)
  {
    for (int end : { 0, 1 })
    {
      region.values[end] = factor * region.values[end] + offset;
      region.gradients[end] *= factor;
    }
  }
  return regions;
}

double LargestRegionGradient(vtkImageData* image)
{
  const std::array<double, 2> range = FiniteRangeOf(image);
  return 0.25 * (range[1] - range[0]) / MeanSpacingMm(image);
}

void ApplyRegions(
  const std::vector<LookRegion>& regions, vtkImageData* image, vtkVolumeProperty* property)
{
  const std::array<double, 2> range = FiniteRangeOf(image);
  const double largestGradient = LargestRegionGradient(image);
  vtkNew<vtkImageData> table;
  table->SetDimensions(TableValues, TableGradients, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  auto* entry = static_cast<float*>(table->GetScalarPointer());
  for (int y = 0; y < TableGradients; ++y)
  {
    for (int x = 0; x < TableValues; ++x)
    {
      const double value = range[0] + (range[1] - range[0]) * x / (TableValues - 1.0);
      const double gradient = largestGradient * y / (TableGradients - 1.0);
      const glm::dvec4 color = ColorInRegions(regions, value, gradient);
      entry = std::copy(&color.r, &color.r + 4, entry);
    }
  }
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  property->SetTransferFunction2D(table);
}

}
