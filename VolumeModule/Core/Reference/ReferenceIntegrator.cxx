#include "Core/Reference/ReferenceIntegrator.h"

#include <glm/geometric.hpp>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>

namespace varimarch
{

ReferenceIntegrator::ReferenceIntegrator(const ReferenceScene& scene, double tolerance)
  : boxGrid(scene.boxGrid)
  , uncutParts(scene.uncutParts)
  , integral(NewRayIntegral(scene, tolerance))
{
  if (!(tolerance >= SmallestTolerance))
  {
    throw std::invalid_argument(
      "Reference: the tolerance must be 1e-12 or more, found " + std::to_string(tolerance));
  }
  if (!scene.cornersOfCell && !scene.material)
  {
    throw std::invalid_argument("Reference: the scene must have voxels or a material, found none");
  }
}

ReferenceColor ReferenceIntegrator::Color(
  const Ray& rayGrid, double mmPerParameter, Interval limits) const
{
  const Interval inside = Intersection(rayGrid, this->boxGrid, limits);
  const glm::dvec4 transparent(0.0);
  if (inside.IsEmpty())
  {
    return { transparent, 0.0 };
  }
  if (!this->uncutParts)
  {
    return this->integral->Along({ rayGrid, mmPerParameter, { inside } });
  }
  const std::vector<Interval> left = this->uncutParts(rayGrid, inside);
  return left.empty() ? ReferenceColor{ transparent, 0.0 }
                      : this->integral->Along({ rayGrid, mmPerParameter, left });
}

namespace
{

using Tile = tbb::blocked_range2d<int>;

/// State that the threads share.
class Drawing
{
public:
  Drawing(const PixelColor& color, const ReferenceView& view, const ProgressFunction& progress)
    : color(color)
    , view(view)
    , progress(progress)
    , image{ view.width, view.height, std::vector<float>(4 * std::size_t(view.width) * view.height),
      0.0 }
  {
  }

  void Draw(const Tile& tile);
  std::optional<ReferenceImage> Result();

private:
  void Report(std::size_t pixels, double largestError);

  ReferenceColor ColorOf(int column, int row) const;

  const PixelColor& color;
  const ReferenceView& view;
  const ProgressFunction& progress;
  ReferenceImage image;
  std::atomic<bool> givenUp = false;
  std::mutex reporting;
  std::size_t pixelsDone = 0;
};

ReferenceColor Drawing::ColorOf(int column, int row) const
{
  const PixelRays& rays = this->view.rays;
  const Ray ray = rays.At(
    2.0 * (column + 0.5) / this->view.width - 1.0, 2.0 * (row + 0.5) / this->view.height - 1.0);
  const double mmPerParameter = glm::length(this->view.worldFromGridDirection * ray.direction);
  return this->color(
    ray, mmPerParameter, rays.BetweenPlanes(ray), std::size_t(row) * this->view.width + column);
}

void Drawing::Draw(const Tile& tile)
{
  if (this->givenUp)
  {
    return;
  }
  double largestError = 0.0;
  for (int row = tile.rows().begin(); row < tile.rows().end(); ++row)
  {
    for (int column = tile.cols().begin(); column < tile.cols().end(); ++column)
    {
      const ReferenceColor color = this->ColorOf(column, row);
      float* rgba = this->image.rgba.data() + 4 * (std::size_t(row) * this->view.width + column);
      for (int channel = 0; channel < 4; ++channel)
      {
        rgba[channel] = float(color.rgba[channel]);
      }
      largestError = std::max(largestError, color.error);
    }
  }
  this->Report(tile.rows().size() * tile.cols().size(), largestError);
}

void Drawing::Report(std::size_t pixels, double largestError)
{
  const std::lock_guard<std::mutex> lock(this->reporting);
  this->pixelsDone += pixels;
  this->image.largestError = std::max(this->image.largestError, largestError);
  const double part = double(this->pixelsDone) / (double(this->view.width) * this->view.height);
  if (this->progress && !this->givenUp && !this->progress(part))
  {
    this->givenUp = true;
  }
}

std::optional<ReferenceImage> Drawing::Result()
{
  return this->givenUp ? std::nullopt : std::optional(std::move(this->image));
}

}

std::optional<ReferenceImage> DrawPixels(
  const PixelColor& color, const ReferenceView& view, const ProgressFunction& progress)
{
  if (view.width < 1 || view.height < 1)
  {
    throw std::invalid_argument("Reference image: width and height must be at least 1, found " +
      std::to_string(view.width) + " x " + std::to_string(view.height));
  }
  constexpr int tileSize = 16;
  Drawing drawing(color, view, progress);
  tbb::parallel_for(Tile(0, view.height, tileSize, 0, view.width, tileSize),
    [&](const Tile& tile) { drawing.Draw(tile); });
  return drawing.Result();
}

std::optional<ReferenceImage> DrawReference(const ReferenceIntegrator& integrator,
  const ReferenceView& view, const ProgressFunction& progress)
{
  return DrawPixels([&](const Ray& ray, double mmPerParameter, Interval limits, std::size_t)
    { return integrator.Color(ray, mmPerParameter, limits); },
    view, progress);
}

}
