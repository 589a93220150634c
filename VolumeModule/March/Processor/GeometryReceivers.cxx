#include "March/Processor/GeometryReceivers.h"

#include "Core/Geometry/TriangleTree.h"
#include "Frame/VolumeGeometry.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

namespace varimarch
{

namespace
{

// The normal of a surface at a place of a triangle, by the normals of its points if it is smooth.
// All triangles whose corners run counter-clockwise show their front, as in VTK.
glm::dvec3 NormalAt(const CastingSurface& surface, const SurfaceTriangle& triangle,
  glm::dvec3 placeWorld, glm::dvec3 againstRayWorld)
{
  std::array<glm::dvec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
  {
    glm::dvec3 corner;
    surface.data->GetPoint(triangle.points[i], glm::value_ptr(corner));
    corners[i] = glm::dvec3(surface.worldFromData * glm::dvec4(corner, 1.0));
  }
  const glm::dvec3 flat = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double side = glm::dot(flat, againstRayWorld) < 0.0 ? -1.0 : 1.0;
  vtkDataArray* const normals = surface.data->GetPointData()->GetNormals();
  if (!normals || surface.property->GetInterpolation() == VTK_FLAT)
  {
    return side * glm::normalize(flat);
  }
  glm::dvec3 smooth(0.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec3 next = corners[(i + 1) % 3] - placeWorld;
    const glm::dvec3 last = corners[(i + 2) % 3] - placeWorld;
    glm::dvec3 normal;
    normals->GetTuple(triangle.points[i], glm::value_ptr(normal));
    smooth += glm::dot(glm::cross(next, last), flat) * normal;
  }
  const double mirrors = glm::determinant(glm::dmat3(surface.worldFromData)) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 world = glm::transpose(glm::inverse(glm::dmat3(surface.worldFromData))) * smooth;
  const double length = glm::length(world);
  return length > 0.0 ? (side * mirrors / length) * world : side * glm::normalize(flat);
}

// Finds the triangles that pixels show. Positions are relative to the origin of the casters.
class PixelSearch
{
public:
  PixelSearch(const Frame& frame, SceneResources& resources, const Viewport& viewport)
    : frame(frame)
    , casters(resources.Casters())
    , places(frame.view, resources.Depth(), viewport, frame.casters.originWorld)
    , eyeWorld(frame.view.eyeWorld)
  {
  }

  std::optional<GeometryReceiver> At(const glm::ivec2& pixel, std::size_t number) const
  {
    const double depth = this->places.DepthAt(pixel);
    if (!(depth < 1.0))
    {
      return std::nullopt;
    }
    const glm::dvec3 place = this->places.PlaceAt(glm::dvec2(pixel), depth);
    const glm::dvec3 away = glm::normalize(
      this->places.PlaceAt(glm::dvec2(pixel), 1.0) - this->places.PlaceAt(glm::dvec2(pixel), 0.0));
    const double reach = this->places.UncertaintyMm(pixel, depth);
    const glm::dvec3 start = place - reach * away;
    const std::optional<TriangleHit> hit = NearestTriangle(this->casters.Tree().Texels<glm::vec4>(),
      glm::vec3(start), glm::vec3(away), float(2.0 * reach));
    if (!hit)
    {
      return std::nullopt;
    }
    const SurfaceTriangle& triangle = this->casters.Sources()[hit->triangle];
    const glm::dvec3 placeWorld = start + double(hit->t) * away + this->frame.casters.originWorld;
    const CastingSurface& surface = this->frame.casters.surfaces[triangle.surface];
    return GeometryReceiver{ number, triangle.surface, placeWorld,
      NormalAt(surface, triangle, placeWorld, -away), glm::normalize(this->eyeWorld - placeWorld),
      this->places.PixelMm(pixel, depth) };
  }

private:
  const Frame& frame;
  const CasterResources& casters;
  PixelPlaces places;
  glm::dvec3 eyeWorld;
};

}

std::vector<GeometryReceiver> GeometryReceiversOf(
  const Frame& frame, SceneResources& resources, const ReceiverGrid& grid)
{
  resources.Depth().Read(frame.view.window);
  const PixelSearch search(frame, resources, grid.viewport);
  const Viewport pixels = grid.Pixels();
  std::vector<std::vector<GeometryReceiver>> rows(std::size_t(pixels.height));
  tbb::parallel_for(0, pixels.height,
    [&](int y)
    {
      for (int x = 0; x < pixels.width; ++x)
      {
        const std::size_t number = std::size_t(y) * std::size_t(pixels.width) + std::size_t(x);
        if (const std::optional<GeometryReceiver> receiver =
              search.At(grid.PixelOf({ x, y }), number))
        {
          rows[std::size_t(y)].push_back(*receiver);
        }
      }
    });
  std::vector<GeometryReceiver> all;
  for (const std::vector<GeometryReceiver>& row : rows)
  {
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

PixelPlaces::PixelPlaces(const FrameView& view, const SceneDepthTexture& depth,
  const Viewport& viewport, const glm::dvec3& originWorld)
  : depths(depth.Texture().Texels<float>())
  , depthPixels(depth.SizePixels())
  , viewport(viewport)
  , placeFromClip(glm::inverse(glm::translate(view.clipFromWorld, originWorld)))
{
}

double PixelPlaces::DepthAt(const glm::ivec2& pixel) const
{
  const glm::dvec2 part =
    (glm::dvec2(pixel) + 0.5) / glm::dvec2(this->viewport.width, this->viewport.height);
  const glm::ivec2 texel =
    glm::min(glm::ivec2(part * glm::dvec2(this->depthPixels)), this->depthPixels - 1);
  return this
    ->depths[std::size_t(texel.y) * std::size_t(this->depthPixels.x) + std::size_t(texel.x)];
}

glm::dvec3 PixelPlaces::PlaceAt(const glm::dvec2& pixel, double depth) const
{
  const glm::dvec4 clip(2.0 * (pixel.x + 0.5) / this->viewport.width - 1.0,
    2.0 * (pixel.y + 0.5) / this->viewport.height - 1.0, 2.0 * depth - 1.0, 1.0);
  const glm::dvec4 place = this->placeFromClip * clip;
  return glm::dvec3(place) / place.w;
}

double PixelPlaces::PixelMm(const glm::ivec2& pixel, double depth) const
{
  return glm::distance(this->PlaceAt(glm::dvec2(pixel) + glm::dvec2(1.0, 0.0), depth),
    this->PlaceAt(glm::dvec2(pixel), depth));
}

double PixelPlaces::UncertaintyMm(const glm::ivec2& pixel, double depth) const
{
  constexpr double DepthStep = 1.0 / (1 << 22);
  constexpr double MostSlope = 16.0;
  const glm::dvec2 center(pixel);
  return glm::distance(this->PlaceAt(center, depth - DepthStep), this->PlaceAt(center, depth)) +
    MostSlope * this->PixelMm(pixel, depth);
}

namespace
{

// Finds the factor of a pixel. Planes and places are relative to the same origin.
class Between
{
public:
  Between(const ReceiverGrid& grid, const std::vector<GeometryReceiver>& receivers,
    const std::vector<glm::vec4>& factors, const glm::dvec3& originWorld)
    : grid(grid)
    , squares(grid.Pixels())
    , factors(factors)
    , planes(factors.size(), glm::dvec4(0.0))
  {
    for (const GeometryReceiver& receiver : receivers)
    {
      this->planes[receiver.pixel] = glm::dvec4(
        receiver.normalWorld, -glm::dot(receiver.normalWorld, receiver.placeWorld - originWorld));
    }
  }

  glm::vec4 FactorAt(const glm::ivec2& pixel, const glm::dvec3& place, double pixelMm) const
  {
    const glm::dvec2 at =
      (glm::dvec2(pixel) - double(this->grid.side / 2)) / double(this->grid.side);
    const glm::ivec2 first(glm::floor(at));
    const glm::dvec2 part = at - glm::dvec2(first);
    glm::dvec4 sum(0.0);
    double weights = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::ivec2 step(corner & 1, corner / 2);
      const glm::ivec2 square = glm::clamp(
        first + step, glm::ivec2(0), glm::ivec2(this->squares.width, this->squares.height) - 1);
      const std::size_t number =
        std::size_t(square.y) * std::size_t(this->squares.width) + std::size_t(square.x);
      const glm::dvec2 nearness = glm::mix(1.0 - part, part, glm::dvec2(step));
      const double weight = nearness.x * nearness.y * this->WeightOf(number, place, pixelMm);
      sum += weight * glm::dvec4(this->factors[number]);
      weights += weight;
    }
    return weights > 0.0 ? glm::vec4(sum / weights) : glm::vec4(1.0f);
  }

private:
  // The weight of a square's plane, 1 if the place is in it and 0 if it is far away. A surface that
  // is curved leaves its plane by less than it extends in it.
  double WeightOf(std::size_t number, const glm::dvec3& place, double pixelMm) const
  {
    const glm::dvec4& plane = this->planes[number];
    if (glm::dvec3(plane) == glm::dvec3(0.0))
    {
      return 0.0;
    }
    const double pixelsAway = std::abs(glm::dot(plane, glm::dvec4(place, 1.0))) / pixelMm;
    return pixelsAway > 2.0 * this->grid.side ? 0.0 : 1.0 / (1.0 + pixelsAway * pixelsAway);
  }

  const ReceiverGrid& grid;
  Viewport squares;
  const std::vector<glm::vec4>& factors;
  std::vector<glm::dvec4> planes; ///< The normal and the offset, or 0 without geometry.
};

}

std::vector<glm::vec4> FactorsBetween(const ReceiverGrid& grid,
  const std::vector<GeometryReceiver>& receivers, const std::vector<glm::vec4>& factors,
  const PixelPlaces& places, const glm::dvec3& originWorld)
{
  const Between between(grid, receivers, factors, originWorld);
  const std::size_t width(grid.viewport.width);
  std::vector<glm::vec4> all(width * std::size_t(grid.viewport.height), glm::vec4(1.0f));
  tbb::parallel_for(0, grid.viewport.height,
    [&](int y)
    {
      for (int x = 0; x < grid.viewport.width; ++x)
      {
        const double depth = places.DepthAt({ x, y });
        if (depth < 1.0)
        {
          all[std::size_t(y) * width + std::size_t(x)] = between.FactorAt(
            { x, y }, places.PlaceAt({ x, y }, depth), places.PixelMm({ x, y }, depth));
        }
      }
    });
  return all;
}

}
