#include "Core/Reference/SplineGrid.h"

#include "Core/Geometry/SplineCoefficients.h"

#include <glm/common.hpp>

#include <array>
#include <utility>

namespace varimarch
{

namespace
{

// Weights at 1 + u of the cubic B-splines centred at 0, 1, 2 and 3, or of their derivatives.
std::array<double, 4> WeightsAt(double u, bool derivative)
{
  const double v = 1.0 - u;
  if (derivative)
  {
    return { -v * v / 2.0, u * (3.0 * u - 4.0) / 2.0, v * (4.0 - 3.0 * v) / 2.0, u * u / 2.0 };
  }
  const auto inner = [](double x) { return (4.0 + 3.0 * x * x * (x - 2.0)) / 6.0; };
  return { v * v * v / 6.0, inner(u), inner(v), u * u * u / 6.0 };
}

}

SplineGrid::SplineGrid(std::vector<double> voxels, glm::ivec3 dimensions)
  : dimensions(dimensions)
  , coefficients(std::move(voxels))
{
  TurnIntoSplineCoefficients(this->coefficients.data(), dimensions);
}

double SplineGrid::Sum(glm::dvec3 positionGrid, glm::ivec3 derivatives) const
{
  const glm::ivec3 last = this->dimensions - 1;
  const glm::dvec3 position = glm::clamp(positionGrid, glm::dvec3(0.0), glm::dvec3(last));
  const glm::ivec3 cell(position);
  std::array<std::array<double, 4>, 3> weights;
  for (int axis = 0; axis < 3; ++axis)
  {
    weights[axis] = WeightsAt(position[axis] - cell[axis], derivatives[axis] != 0);
  }
  double sum = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    const glm::ivec3 offset(i % 4, i / 4 % 4, i / 16);
    const glm::ivec3 voxel = glm::clamp(cell + offset - 1, glm::ivec3(0), last);
    const double weight = weights[0][offset.x] * weights[1][offset.y] * weights[2][offset.z];
    sum += weight *
      this->coefficients[voxel.x +
        std::size_t(this->dimensions.x) * (voxel.y + std::size_t(this->dimensions.y) * voxel.z)];
  }
  return sum;
}

double SplineGrid::Value(glm::dvec3 positionGrid) const
{
  return this->Sum(positionGrid, glm::ivec3(0));
}

glm::dvec3 SplineGrid::Gradient(glm::dvec3 positionGrid) const
{
  return { this->Sum(positionGrid, { 1, 0, 0 }), this->Sum(positionGrid, { 0, 1, 0 }),
    this->Sum(positionGrid, { 0, 0, 1 }) };
}

}
