#include "Scene/Slices/SliceAxes.h"

#include "Scene/Model/WorldVector.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

SliceAxes AnatomicalAxes(SlicePlane plane)
{
  switch (plane)
  {
    case SlicePlane::Coronal:
      return { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 1.0, 0.0 } };
    case SlicePlane::Sagittal:
      return { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 1.0, 0.0, 0.0 } };
    default:
      return { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  }
}

glm::dquat RotationOf(const SliceTurn& turn)
{
  const glm::dvec3 vector = VectorOf(turn);
  const double degrees = glm::length(vector);
  return degrees > 0.0 ? glm::angleAxis(glm::radians(degrees), vector / degrees)
                       : glm::identity<glm::dquat>();
}

// A rotation of at most 180 degrees; q and -q are the same one.
SliceTurn TurnOf(glm::dquat rotation)
{
  rotation = glm::normalize(rotation.w < 0.0 ? -rotation : rotation);
  const glm::dvec3 vector(rotation.x, rotation.y, rotation.z);
  const double sine = glm::length(vector);
  return sine > 0.0 ? NumbersOf(glm::degrees(2.0 * std::atan2(sine, rotation.w)) * (vector / sine))
                    : SliceTurn();
}

}

SliceAxes AxesOf(SlicePlane plane, const SliceTurn& turn)
{
  const SliceAxes straight = AnatomicalAxes(plane);
  if (turn == SliceTurn())
  {
    return straight;
  }
  const glm::dvec3 straightThrough = VectorOf(straight.through);
  const glm::dvec3 through = RotationOf(turn) * straightThrough;
  // The shortest rotation from the anatomical plane to the turned one. If they face each other, it
  // is one about the columns of the image.
  const glm::dvec3 axis = glm::cross(straightThrough, through);
  const double sine = glm::length(axis);
  const double angle = std::atan2(sine, glm::dot(straightThrough, through));
  const glm::dquat tilt =
    glm::angleAxis(angle, sine > 1e-9 ? axis / sine : VectorOf(straight.down));
  return { NumbersOf(tilt * VectorOf(straight.right)), NumbersOf(tilt * VectorOf(straight.down)),
    NumbersOf(through) };
}

SliceTurn TurnedBy(const SliceTurn& turn, const std::array<double, 3>& axis, double degrees)
{
  return TurnOf(glm::angleAxis(glm::radians(degrees), VectorOf(axis)) * RotationOf(turn));
}

std::string AnatomicalDirection(const double directionWorld[3])
{
  constexpr double Negligible = 0.05;
  constexpr std::array<const char*, 3> Letters = { "RL", "AP", "IS" }; // towards -, towards +
  const double length = std::hypot(directionWorld[0], directionWorld[1], directionWorld[2]);
  std::array<int, 3> axes = { 0, 1, 2 };
  std::stable_sort(axes.begin(), axes.end(),
    [&](int a, int b) { return std::abs(directionWorld[a]) > std::abs(directionWorld[b]); });
  std::string letters;
  for (const int axis : axes)
  {
    if (std::abs(directionWorld[axis]) > Negligible * length)
    {
      letters += Letters[axis][directionWorld[axis] > 0.0];
    }
  }
  return letters;
}

}
