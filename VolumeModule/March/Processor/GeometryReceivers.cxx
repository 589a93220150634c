#include "March/Processor/GeometryReceivers.h"

#include "Core/Geometry/TriangleTree.h"
#include "March/Processor/PixelPlaces.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
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
    , places(frame.view.renderer, resources.Depth(), viewport, frame.casters.originWorld)
    , eyeWorld(glm::make_vec3(frame.view.renderer->GetActiveCamera()->GetPosition()))
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

}
