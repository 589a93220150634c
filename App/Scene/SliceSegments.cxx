#include "Scene/SliceSegments.h"

#include "Scene/SliceGrid.h"

#include <vtkImageData.h>

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr int OutlinePixels = 2;
constexpr double FillOpacity = 0.3; // the values of the scan remain legible

template <class DrawRow>
void ForEachRow(int rowCount, const DrawRow& drawRow)
{
  tbb::parallel_for(tbb::blocked_range<int>(0, rowCount),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        drawRow(row);
      }
    });
}

// The number of the visible segment at each pixel; 0 without one.
std::vector<std::uint8_t> VisibleNumbers(
  vtkImageData* image, const std::vector<Segment>& segments, const SliceRequest& request)
{
  const SliceGrid grid(image, request);
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height, 0);
  ForEachRow(request.height,
    [&](int row)
    {
      std::uint8_t* pixel = pixels.data() + std::size_t(row) * request.width;
      for (int column = 0; column < request.width; ++column, ++pixel)
      {
        const glm::dvec3 index = grid.IndexAt(column, row);
        if (grid.Holds(index))
        {
          const glm::ivec3 voxel(glm::round(index));
          const std::uint8_t number =
            *static_cast<const std::uint8_t*>(image->GetScalarPointer(voxel.x, voxel.y, voxel.z));
          *pixel = number > 0 && segments[number - 1].visible ? number : 0;
        }
      }
    });
  return pixels;
}

// True where another segment, or none, begins within the width of an outline. The edge of the slice
// is no border.
bool IsOutline(
  const std::vector<std::uint8_t>& numbers, const SliceRequest& request, int column, int row)
{
  const auto numberAt = [&](int x, int y) { return numbers[std::size_t(y) * request.width + x]; };
  const std::uint8_t own = numberAt(column, row);
  for (int away = 1; away <= OutlinePixels; ++away)
  {
    if ((column >= away && numberAt(column - away, row) != own) ||
      (column + away < request.width && numberAt(column + away, row) != own) ||
      (row >= away && numberAt(column, row - away) != own) ||
      (row + away < request.height && numberAt(column, row + away) != own))
    {
      return true;
    }
  }
  return false;
}

Rgba ColorOf(const Segment& segment, double opacity)
{
  const glm::dvec3 rgb = glm::round(255.0 * segment.rgb);
  return { std::uint8_t(rgb.r), std::uint8_t(rgb.g), std::uint8_t(rgb.b),
    std::uint8_t(std::lround(255.0 * opacity)) };
}

}

std::vector<Rgba> SliceSegments(
  vtkImageData* numbers, const std::vector<Segment>& segments, const SliceRequest& request)
{
  const std::vector<std::uint8_t> visible = VisibleNumbers(numbers, segments, request);
  std::vector<Rgba> pixels(visible.size(), Rgba{});
  ForEachRow(request.height,
    [&](int row)
    {
      for (int column = 0; column < request.width; ++column)
      {
        const std::size_t pixel = std::size_t(row) * request.width + column;
        if (visible[pixel] > 0)
        {
          const Segment& segment = segments[visible[pixel] - 1];
          const bool isOutline = IsOutline(visible, request, column, row);
          pixels[pixel] = ColorOf(segment, isOutline ? 1.0 : FillOpacity * segment.opacity);
        }
      }
    });
  return pixels;
}

}
