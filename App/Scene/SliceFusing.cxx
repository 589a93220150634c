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
  const auto alpha = std::uint8_t(std::lround(255.0 * fused.opacity));
  std::vector<Rgba> pixels(grays.size(), Rgba{});
  tbb::parallel_for(tbb::blocked_range<int>(0, request.height),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column < request.width; ++column)
        {
          const std::size_t pixel = std::size_t(row) * request.width + column;
          const bool isShown = fused.fusion == SliceFusion::Blend || board.ShowsUpper(column, row);
          if (isShown && grid.Holds(grid.IndexAt(column, row)))
          {
            const auto rgb = SliceColorOf(fused.colors, grays[pixel] / 255.0);
            pixels[pixel] = { rgb[0], rgb[1], rgb[2], alpha };
          }
        }
      }
    });
  return pixels;
}

}
