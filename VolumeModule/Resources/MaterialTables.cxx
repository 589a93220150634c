#include "Resources/MaterialTables.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

glm::vec4 ColorAt(vtkDataArray* colors, vtkIdType index)
{
  glm::vec4 color;
  for (int component = 0; component < 4; ++component)
  {
    color[component] = float(std::clamp(colors->GetComponent(index, component), 0.0, 1.0));
  }
  return color;
}

// True if the largest value exceeds 1 by more than rounding.
bool ExceedsOne(const VoxelComponent& component)
{
  constexpr double Rounded = 1.001;
  double range[2];
  component.array->GetFiniteRange(range, component.index);
  return range[1] > Rounded;
}

}

TwoValueTable TwoValueTableOf(vtkImageData* image)
{
  vtkDataArray* const colors = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!colors || colors->GetNumberOfComponents() != 4 || image->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("The transfer function of two values is missing: expected an image of "
                             "four components");
  }
  if (colors->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::runtime_error("The transfer function of two values has " +
      std::to_string(colors->GetNumberOfTuples()) + " entries: expected one for each of the " +
      std::to_string(image->GetNumberOfPoints()) + " points of its image");
  }
  const int* const dimensions = image->GetDimensions();
  TwoValueTable table{ { std::max(dimensions[0], 2), std::max(dimensions[1], 2) }, {} };
  for (int y = 0; y < table.size.y; ++y)
  {
    for (int x = 0; x < table.size.x; ++x)
    {
      const vtkIdType row = std::min(y, dimensions[1] - 1);
      const vtkIdType entry = row * dimensions[0] + std::min(x, dimensions[0] - 1);
      table.entries.push_back(ColorAt(colors, entry));
    }
  }
  return table;
}

OpticalTable UpperBound(
  const TwoValueTable& table, const std::array<double, 2>& range, double opacityUnitDistanceMm)
{
  OpticalTable bound{ range[0], range[1], {} };
  for (int x = 0; x < table.size.x; ++x)
  {
    double opacity = 0.0;
    for (int y = 0; y < table.size.y; ++y)
    {
      opacity = std::max(opacity, double(table.entries[std::size_t(y) * table.size.x + x].a));
    }
    const double extinction =
      std::min(-std::log1p(-opacity) / opacityUnitDistanceMm, double(OpaqueExtinction));
    bound.entries.emplace_back(1.0, 1.0, 1.0, extinction);
  }
  return bound;
}

int OpacityComponentOf(const RenderSettings& settings, int part)
{
  switch (settings.components)
  {
    case Components::LuminanceOpacity:
      return 1;
    case Components::Rgba:
      return 3;
    default:
      return part;
  }
}

double LargestColorOf(const VoxelComponents& components)
{
  vtkDataArray* const array = components.front().array;
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return std::any_of(components.begin(), components.begin() + 3, ExceedsOne) ? 255.0 : 1.0;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return array->GetDataTypeMax();
    default:
      return 255.0;
  }
}

}
