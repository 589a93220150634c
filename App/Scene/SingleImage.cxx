#include "Scene/SingleImage.h"

#include "Scene/WorldVector.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The only axis along which a volume has one voxel; empty if there is none, or more.
std::optional<int> AxisOfOneVoxel(vtkImageData* volume)
{
  const int* const count = volume->GetDimensions();
  return std::count(count, count + 3, 1) == 1
    ? std::optional(int(std::find(count, count + 3, 1) - count))
    : std::nullopt;
}

// The shortest rotation of a direction onto the line of another one.
SliceTurn TurnOnto(const glm::dvec3& from, const glm::dvec3& line)
{
  constexpr double SmallestSine = 1e-9;
  const glm::dvec3 to = glm::dot(from, line) < 0.0 ? -line : line;
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  return sine < SmallestSine
    ? SliceTurn()
    : TurnedBy({}, NumbersOf(axis / sine), glm::degrees(std::atan2(sine, glm::dot(from, to))));
}

}

std::optional<SingleImage> SingleImageOf(vtkImageData* volume)
{
  const std::optional<int> axis = AxisOfOneVoxel(volume);
  if (!axis)
  {
    return std::nullopt;
  }
  vtkMatrix3x3* const direction = volume->GetDirectionMatrix();
  const glm::dvec3 normal = glm::normalize(glm::dvec3(direction->GetElement(0, *axis),
    direction->GetElement(1, *axis), direction->GetElement(2, *axis)));
  const auto throughOf = [](SlicePlane plane) { return VectorOf(AxesOf(plane).through); };
  const SlicePlane planes[] = { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal };
  const SlicePlane nearest = *std::max_element(std::begin(planes), std::end(planes),
    [&](SlicePlane a, SlicePlane b) {
      return std::abs(glm::dot(throughOf(a), normal)) < std::abs(glm::dot(throughOf(b), normal));
    });
  return SingleImage{ nearest, TurnOnto(throughOf(nearest), normal) };
}

SliceTurn FirstTurnOf(vtkImageData* volume)
{
  const std::optional<SingleImage> single = SingleImageOf(volume);
  return single ? single->turn : SliceTurn();
}

}
