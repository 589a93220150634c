#include "Scene/Slices/SliceFusing.h"

#include "Scene/Model/WorldVector.h"

#include <vtkImageData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double SquareMm = 20.0;

// True in the squares of a checkerboard that show the upper volume.
class Checkerboard
{
public:
  explicit Checkerboard(const SliceRequest& request)
    : mmPerPixel(request.mmPerPixel)
  {
    const SliceAxes axes = AxesOf(request.plane, request.turn);
    const glm::dvec3 middle = VectorOf(request.middleMm);
    this->leftMm =
      glm::dot(middle, VectorOf(axes.right)) + (0.5 - 0.5 * request.width) * mmPerPixel;
    this->topMm = glm::dot(middle, VectorOf(axes.down)) + (0.5 - 0.5 * request.height) * mmPerPixel;
  }

  bool ShowsUpper(int column, int row) const
  {
    const double x = std::floor((this->leftMm + column * this->mmPerPixel) / SquareMm);
    const double y = std::floor((this->topMm + row * this->mmPerPixel) / SquareMm);
    return std::fmod(std::abs(x + y), 2.0) == 1.0;
  }

private:
  double mmPerPixel;
  double leftMm;
  double topMm;
};

// Blended colours that begin with black are light: black lets everything below through. Greys are
// values, of which black is one, and the squares of a checkerboard show nothing else.
Rgba PixelOf(const FusedSlice& fused, double part)
{
  const auto byteOf = [](double value) { return std::uint8_t(std::lround(value)); };
  const auto rgb = SliceColorOf(fused.colors, part);
  if (fused.colors == SliceColors::Gray || fused.fusion != SliceFusion::Blend)
  {
    return { rgb[0], rgb[1], rgb[2], byteOf(255.0 * fused.opacity) };
  }
  const double brightest = *std::max_element(rgb.begin(), rgb.end());
  const auto pure = [&](double channel) { return byteOf(255.0 * channel / brightest); };
  return brightest == 0.0
    ? Rgba{}
    : Rgba{ pure(rgb[0]), pure(rgb[1]), pure(rgb[2]), byteOf(fused.opacity * brightest) };
}

}

std::array<std::uint8_t, 3> SliceColorOf(SliceColors colors, double part)
{
  const auto byteOf = [](double channel)
  { return std::uint8_t(std::lround(255.0 * std::clamp(channel, 0.0, 1.0))); };
  switch (colors)
  {
    case SliceColors::Hot:
      return { byteOf(3.0 * part), byteOf(3.0 * part - 1.0), byteOf(3.0 * part - 2.0) };
    case SliceColors::Green:
      return { 0, byteOf(part), 0 };
    default:
      return { byteOf(part), byteOf(part), byteOf(part) };
  }
}

std::vector<Rgba> FusedPixels(
  vtkImageData* image, const SliceRequest& request, const FusedSlice& fused)
{
  const std::vector<std::uint8_t> grays = SlicePicture(image, request);
  const SliceGrid grid(image, request);
  const Checkerboard board(request);
  std::vector<Rgba> pixels(grays.size(), Rgba{});
  tbb::parallel_for(tbb::blocked_range<int>(0, request.height),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column < request.width; ++column)
        {
          const std::size_t pixel = std::size_t(row) * request.width + column;
          const bool isBlend = fused.fusion == SliceFusion::Blend;
          if ((isBlend || board.ShowsUpper(column, row)) && grid.Holds(grid.IndexAt(column, row)))
          {
            pixels[pixel] = PixelOf(fused, grays[pixel] / 255.0);
          }
        }
      }
    });
  return pixels;
}

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
