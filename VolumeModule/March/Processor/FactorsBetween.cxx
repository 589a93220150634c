#include "March/Processor/FactorsBetween.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <tbb/parallel_for.h>

#include <cstddef>

namespace varimarch
{

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
