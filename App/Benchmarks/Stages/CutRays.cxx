#include "Stages/CutRays.h"

#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

glm::dvec3 Moved(const glm::dmat4& matrix, glm::dvec3 position)
{
  return glm::dvec3(matrix * glm::dvec4(position, 1.0));
}

// Root of a function that is linear along the ray.
template <class Function>
double RootOf(Function function)
{
  return function(0.0) / (function(0.0) - function(1.0));
}

}

CutRays::CutRays(
  vtkVolumeMapper* mapper, const glm::dmat4& worldFromGrid, const glm::dmat4& dataFromGrid)
  : mapper(mapper)
  , worldFromGrid(worldFromGrid)
  , dataFromGrid(dataFromGrid)
{
}

bool CutRays::IsLeft(glm::dvec3 positionGrid) const
{
  const glm::dvec3 world = Moved(this->worldFromGrid, positionGrid);
  vtkPlaneCollection* const planes = this->mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    if (planes->GetItem(i)->EvaluateFunction(world.x, world.y, world.z) < 0.0)
    {
      return false;
    }
  }
  const glm::dvec3 data = Moved(this->dataFromGrid, positionGrid);
  const double* const places = this->mapper->GetCroppingRegionPlanes();
  int region = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int index =
      data[axis] < places[2 * axis] ? 0 : (data[axis] <= places[2 * axis + 1] ? 1 : 2);
    region = 3 * region + index;
  }
  return !this->mapper->GetCropping() ||
    (this->mapper->GetCroppingRegionFlags() >> region & 1) != 0;
}

std::vector<Interval> CutRays::operator()(const Ray& rayGrid, Interval inside) const
{
  const auto positionAt = [&](double t) { return rayGrid.origin + t * rayGrid.direction; };
  std::vector<double> ends = { inside.enter, inside.exit };
  const auto addRoot = [&](double t)
  {
    if (inside.enter < t && t < inside.exit)
    {
      ends.push_back(t);
    }
  };
  vtkPlaneCollection* const planes = this->mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    addRoot(RootOf(
      [&](double t)
      {
        glm::dvec3 world = Moved(this->worldFromGrid, positionAt(t));
        return planes->GetItem(i)->EvaluateFunction(glm::value_ptr(world));
      }));
  }
  for (int plane = 0; plane < 6 && this->mapper->GetCropping(); ++plane)
  {
    addRoot(RootOf(
      [&](double t)
      {
        return Moved(this->dataFromGrid, positionAt(t))[plane / 2] -
          this->mapper->GetCroppingRegionPlanes()[plane];
      }));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Interval> left;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    if (ends[i] < ends[i + 1] && this->IsLeft(positionAt(0.5 * (ends[i] + ends[i + 1]))))
    {
      left.push_back({ ends[i], ends[i + 1] });
    }
  }
  return left;
}

}
