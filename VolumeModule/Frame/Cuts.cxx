#include "Frame/Cuts.h"

#include "Frame/NumberCheck.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolumeMapper.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr int SubVolume = 0x2000; // the region in the middle
constexpr int AllRegions = 0x7ffffff;

// Transforms a plane to grid space and scales it so that floats can hold it.
glm::dvec4 PlaneInGrid(glm::dvec4 plane, const glm::dmat4& spaceFromGrid)
{
  const glm::dvec4 planeGrid = plane * spaceFromGrid;
  const double size = glm::length(glm::dvec3(planeGrid));
  return size > 0.0 ? planeGrid / size : planeGrid;
}

// The axis that a plane is perpendicular to; none if the plane is oblique.
std::optional<int> AxisOf(const glm::dvec4& plane)
{
  constexpr double rounding = 1e-12; // the error of the products that made the unit normal
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(std::abs(plane[axis]) - 1.0) < rounding &&
      std::abs(plane[(axis + 1) % 3]) < rounding && std::abs(plane[(axis + 2) % 3]) < rounding)
    {
      return axis;
    }
  }
  return std::nullopt;
}

void Cut(Cuts& cuts, const glm::dvec4& planeGrid)
{
  const std::optional<int> axis = AxisOf(planeGrid);
  if (!axis)
  {
    cuts.planesGrid.push_back(planeGrid);
    return;
  }
  const double place = -planeGrid.w / planeGrid[*axis];
  double& lower = cuts.boxGrid.lower[*axis];
  double& upper = cuts.boxGrid.upper[*axis];
  lower = planeGrid[*axis] > 0.0 ? std::max(lower, place) : lower;
  upper = planeGrid[*axis] < 0.0 ? std::min(upper, place) : upper;
}

bool IsPlane(const glm::dvec4& plane)
{
  const double sum = plane.x + plane.y + plane.z + plane.w;
  return std::isfinite(sum) && glm::dvec3(plane) != glm::dvec3(0.0);
}

std::vector<glm::dvec4> PlanesInGrid(
  vtkPlaneCollection* planes, const glm::dmat4& worldFromGrid, NumberCheck& check)
{
  std::vector<glm::dvec4> planesGrid;
  vtkCollectionSimpleIterator iterator;
  planes->InitTraversal(iterator);
  while (vtkPlane* plane = planes->GetNextPlane(iterator))
  {
    const glm::dvec3 normalWorld = glm::make_vec3(plane->GetNormal());
    const glm::dvec3 originWorld = glm::make_vec3(plane->GetOrigin());
    const glm::dvec4 planeGrid =
      PlaneInGrid({ normalWorld, -glm::dot(normalWorld, originWorld) }, worldFromGrid);
    if (IsPlane(planeGrid))
    {
      planesGrid.push_back(planeGrid);
      continue;
    }
    check.Note("Cannot cut by a vtkPlane with the normal " + TextOf(normalWorld) +
      " and the origin " + TextOf(originWorld) +
      ": expected finite numbers, and a normal other than 0. It is left out; set other numbers.");
  }
  return planesGrid;
}

// The places of the six planes. One that is NaN or infinite lies beyond all volumes.
std::array<double, 6> CroppingPlacesOf(vtkVolumeMapper* mapper, NumberCheck& check)
{
  std::array<double, 6> places;
  for (int plane = 0; plane < 6; ++plane)
  {
    const double beyond = plane % 2 == 0 ? -LargestSetting : LargestSetting;
    const double place = mapper->GetCroppingRegionPlanes()[plane];
    places[plane] =
      check.Usable({ "SetCroppingRegionPlanes", -LargestSetting, LargestSetting, beyond },
        std::isinf(place) ? std::copysign(LargestSetting, place) : place);
  }
  return places;
}

void Crop(Cuts& cuts, vtkVolumeMapper* mapper, const glm::dmat4& dataFromGrid, NumberCheck& check)
{
  const std::array<double, 6> places = CroppingPlacesOf(mapper, check);
  CroppingRegions regions{ {}, mapper->GetCroppingRegionFlags() & AllRegions };
  bool isEmpty = regions.drawn == 0;
  for (int plane = 0; plane < 6; ++plane)
  {
    glm::dvec4 planeData(0.0, 0.0, 0.0, -places[plane]);
    planeData[plane / 2] = 1.0;
    regions.planesGrid[plane] = PlaneInGrid(planeData, dataFromGrid);
    isEmpty = isEmpty || !(places[plane / 2 * 2] < places[plane / 2 * 2 + 1]);
  }
  if (isEmpty)
  {
    cuts.boxGrid.upper = cuts.boxGrid.lower;
  }
  else if (regions.drawn == SubVolume)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Cut(cuts, regions.planesGrid[2 * axis]);
      Cut(cuts, -regions.planesGrid[2 * axis + 1]);
    }
  }
  else if (regions.drawn != AllRegions)
  {
    cuts.regions = regions;
  }
}

}

Cuts CutsOf(
  vtkVolumeMapper* mapper, const VolumeGeometry& geometry, bool keepPlanes, NumberCheck& check)
{
  Cuts cuts{ geometry.boxGrid, {}, {} };
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    for (const glm::dvec4& plane : PlanesInGrid(planes, geometry.worldFromGrid, check))
    {
      keepPlanes ? cuts.planesGrid.push_back(plane) : Cut(cuts, plane);
    }
  }
  if (mapper->GetCropping())
  {
    Crop(cuts, mapper, geometry.dataFromGrid, check);
  }
  return cuts;
}

}
