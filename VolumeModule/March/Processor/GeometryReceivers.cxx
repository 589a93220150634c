#include "March/Processor/GeometryReceivers.h"

#include "Core/Geometry/TriangleTree.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

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
    , depths(resources.Depth().Texture().Texels<float>())
    , depthPixels(resources.Depth().SizePixels())
    , viewport(viewport)
    , placeFromClip(
        glm::inverse(glm::translate(ClipFromWorld(frame.view.renderer), frame.casters.originWorld)))
    , eyeWorld(glm::make_vec3(frame.view.renderer->GetActiveCamera()->GetPosition()))
  {
  }

  std::optional<GeometryReceiver> At(int x, int y) const
  {
    const double depth = this->DepthAt(x, y);
    if (!(depth < 1.0))
    {
      return std::nullopt;
    }
    const glm::dvec3 place = this->PlaceAt(x, y, depth);
    const glm::dvec3 away = glm::normalize(this->PlaceAt(x, y, 1.0) - this->PlaceAt(x, y, 0.0));
    const double reach = this->UncertaintyMm(x, y, depth);
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
    return GeometryReceiver{ std::size_t(y) * std::size_t(this->viewport.width) + std::size_t(x),
      triangle.surface, placeWorld, NormalAt(surface, triangle, placeWorld, -away),
      glm::normalize(this->eyeWorld - placeWorld) };
  }

private:
  double DepthAt(int x, int y) const
  {
    const auto texelOf = [](int pixel, int pixels, int texels)
    { return std::min(int((pixel + 0.5) * texels / pixels), texels - 1); };
    const int column = texelOf(x, this->viewport.width, this->depthPixels.x);
    const int row = texelOf(y, this->viewport.height, this->depthPixels.y);
    return this->depths[std::size_t(row) * std::size_t(this->depthPixels.x) + std::size_t(column)];
  }

  glm::dvec3 PlaceAt(double x, double y, double depth) const
  {
    const glm::dvec4 clip(2.0 * (x + 0.5) / this->viewport.width - 1.0,
      2.0 * (y + 0.5) / this->viewport.height - 1.0, 2.0 * depth - 1.0, 1.0);
    const glm::dvec4 place = this->placeFromClip * clip;
    return glm::dvec3(place) / place.w;
  }

  // How far a depth may be from the surface along the ray: by the bits of the depth buffer, and by
  // the slope of the surface within a pixel, whose depth may be that of a place off its centre.
  double UncertaintyMm(int x, int y, double depth) const
  {
    constexpr double DepthStep = 1.0 / (1 << 22);
    constexpr double MostSlope = 16.0;
    const glm::dvec3 place = this->PlaceAt(x, y, depth);
    return glm::distance(this->PlaceAt(x, y, depth - DepthStep), place) +
      MostSlope * glm::distance(this->PlaceAt(x + 1.0, y, depth), place);
  }

  const Frame& frame;
  const CasterResources& casters;
  const float* depths;
  glm::ivec2 depthPixels;
  Viewport viewport;
  glm::dmat4 placeFromClip;
  glm::dvec3 eyeWorld;
};

}

std::vector<GeometryReceiver> GeometryReceiversOf(
  const Frame& frame, SceneResources& resources, const Viewport& viewport)
{
  resources.Depth().Read(frame.view.window);
  const PixelSearch search(frame, resources, viewport);
  std::vector<std::vector<GeometryReceiver>> rows(std::size_t(viewport.height));
  tbb::parallel_for(0, viewport.height,
    [&](int y)
    {
      for (int x = 0; x < viewport.width; ++x)
      {
        if (const std::optional<GeometryReceiver> receiver = search.At(x, y))
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
