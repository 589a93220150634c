#include "Frame/CasterTriangles.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <tbb/parallel_for.h>

namespace varimarch
{

namespace
{

// Calls add(number of points, points) for each cell.
template <class Add>
void ForEachCell(vtkCellArray* cells, Add add)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    add(count, ids);
  }
}

// The triangles of a surface, before planes cut them. Polygons are fans from their first corner, as
// for polygons without a notch.
std::vector<SurfaceTriangle> WholeTriangles(const ShadowCasters& casters, std::size_t surface)
{
  vtkPolyData* const data = casters.surfaces[surface].data;
  std::vector<SurfaceTriangle> triangles;
  ForEachCell(data->GetPolys(),
    [&](vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < count; ++i)
      {
        triangles.push_back({ surface, { ids[0], ids[i - 1], ids[i] } });
      }
    });
  ForEachCell(data->GetStrips(),
    [&](vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < count; ++i)
      {
        const vtkIdType turned = i % 2; // every second triangle of a strip runs the other way round
        triangles.push_back({ surface, { ids[i - 2 + turned], ids[i - 1 - turned], ids[i] } });
      }
    });
  return triangles;
}

glm::dvec3 CornerWorld(const CastingSurface& surface, vtkIdType point)
{
  glm::dvec3 place;
  surface.data->GetPoint(point, glm::value_ptr(place));
  return glm::dvec3(surface.worldFromData * glm::dvec4(place, 1.0));
}

// Cuts a polygon by a plane, as Sutherland and Hodgman do (Communications of the ACM, 1974).
std::vector<glm::dvec3> CutBy(const glm::dvec4& plane, const std::vector<glm::dvec3>& corners)
{
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3& from = corners[i];
    const glm::dvec3& to = corners[(i + 1) % corners.size()];
    const double fromAbove = glm::dot(plane, glm::dvec4(from, 1.0));
    const double toAbove = glm::dot(plane, glm::dvec4(to, 1.0));
    if (fromAbove >= 0.0)
    {
      kept.push_back(from);
    }
    if ((fromAbove >= 0.0) != (toAbove >= 0.0))
    {
      kept.push_back(glm::mix(from, to, fromAbove / (fromAbove - toAbove)));
    }
  }
  return kept;
}

// The triangles that planes leave.
CasterTriangles CutTriangles(
  const ShadowCasters& casters, std::size_t surface, const std::vector<SurfaceTriangle>& whole)
{
  const CastingSurface& cut = casters.surfaces[surface];
  CasterTriangles left;
  for (const SurfaceTriangle& source : whole)
  {
    std::vector<glm::dvec3> corners;
    for (const vtkIdType point : source.points)
    {
      corners.push_back(CornerWorld(cut, point));
    }
    for (const glm::dvec4& plane : cut.planesWorld)
    {
      corners = CutBy(plane, corners);
    }
    const auto cornerAt = [&](std::size_t i)
    { return glm::vec3(corners[i] - casters.originWorld); };
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      left.corners.push_back({ cornerAt(0), cornerAt(i - 1), cornerAt(i) });
      left.sources.push_back(source);
    }
  }
  return left;
}

}

CasterTriangles TrianglesOf(const ShadowCasters& casters, std::size_t surface)
{
  const CastingSurface& whole = casters.surfaces[surface];
  CasterTriangles made;
  made.sources = WholeTriangles(casters, surface);
  if (!whole.planesWorld.empty())
  {
    return CutTriangles(casters, surface, made.sources);
  }
  made.corners.resize(made.sources.size());
  tbb::parallel_for(std::size_t(0), made.sources.size(),
    [&](std::size_t i)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        made.corners[i][corner] =
          CornerWorld(whole, made.sources[i].points[corner]) - casters.originWorld;
      }
    });
  return made;
}

}
