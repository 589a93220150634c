#include "Scene/SliceFusing.h"

#include "Scene/SliceGrid.h"
#include "Scene/WorldVector.h"

#include <vtkImageData.h>

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

}
