#include "Frame/SliceSurface.h"

#include "vtkImplicitFunction.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

// The function in coordinates that are [-1, 1] along each axis of the volume's box.
class BoxFunction
{
public:
  BoxFunction(vtkImplicitFunction* function, const glm::dmat4& worldFromBox)
    : function(function)
    , worldFromBox(worldFromBox)
  {
  }

  double operator()(glm::dvec3 position) const
  {
    const glm::dvec4 world = this->worldFromBox * glm::dvec4(position, 1.0);
    return this->function->FunctionValue(world.x, world.y, world.z);
  }

private:
  vtkImplicitFunction* function;
  glm::dmat4 worldFromBox;
};

glm::dvec3 Axis(int axis)
{
  glm::dvec3 unit(0.0);
  unit[axis] = 1.0;
  return unit;
}

// The matrix of a function of second degree, from ten of its values.
glm::dmat4 MatrixOf(const BoxFunction& function)
{
  const double center = function(glm::dvec3(0.0));
  glm::dmat4 matrix(0.0);
  matrix[3][3] = center;
  for (int i = 0; i < 3; ++i)
  {
    const double after = function(Axis(i));
    const double before = function(-Axis(i));
    matrix[i][i] = 0.5 * (after + before) - center;
    matrix[i][3] = matrix[3][i] = 0.25 * (after - before);
    for (int j = 0; j < i; ++j)
    {
      const double mixed = function(Axis(i) + Axis(j)) - after - function(Axis(j)) + center;
      matrix[i][j] = matrix[j][i] = 0.5 * mixed;
    }
  }
  return matrix;
}

double LargestEntry(const glm::dmat4& matrix)
{
  double largest = 0.0;
  for (int i = 0; i < 16; ++i)
  {
    largest = std::max(largest, std::abs(matrix[i / 4][i % 4]));
  }
  return largest;
}

// Compares both at points that were not used to make the matrix.
bool IsAsTheFunction(const glm::dmat4& matrix, const BoxFunction& function, double allowed)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    for (double reach : { 1.0, 0.37 })
    {
      const glm::dvec4 position(corner & 1 ? reach : -reach, corner & 2 ? reach : -0.8 * reach,
        corner & 4 ? 0.7 * reach : -reach, 1.0);
      const double value = glm::dot(position, matrix * position);
      if (!(std::abs(value - function(glm::dvec3(position))) <= allowed))
      {
        return false;
      }
    }
  }
  return true;
}

}

SliceSurface SliceSurfaceOf(vtkImplicitFunction* function, const VolumeGeometry& geometry)
{
  constexpr double rounding = 1e-9; // the relative error of the values that a matrix is made from
  const Box& box = geometry.boxGrid;
  const glm::dvec3 center = 0.5 * (box.lower + box.upper);
  const glm::dvec3 halfSize = 0.5 * (box.upper - box.lower);
  const glm::dmat4 gridFromBox = glm::scale(glm::translate(glm::dmat4(1.0), center), halfSize);
  const BoxFunction boxFunction(function, geometry.worldFromGrid * gridFromBox);
  glm::dmat4 matrix = MatrixOf(boxFunction);
  const double largest = LargestEntry(matrix);
  if (!IsFinite(matrix))
  {
    throw std::invalid_argument(std::string("Cannot draw a slice by ") + function->GetClassName() +
      ", whose values in the volume are not finite: expected finite numbers; set other ones");
  }
  if (!IsAsTheFunction(matrix, boxFunction, rounding * largest))
  {
    throw std::runtime_error(std::string("Slices by ") + function->GetClassName() +
      " are not supported: expected a function of second degree, such as vtkPlane, vtkSphere, "
      "vtkCylinder, vtkCone or vtkQuadric");
  }
  for (int i = 0; i < 16; ++i)
  {
    double& entry = matrix[i / 4][i % 4];
    // For a plane, for example, a tiny entry is a rounding error.
    entry = std::abs(entry) <= rounding * largest ? 0.0 : entry;
  }
  const glm::dmat4 boxFromCentered = glm::scale(glm::dmat4(1.0), 1.0 / halfSize);
  matrix = glm::transpose(boxFromCentered) * matrix * boxFromCentered;
  const double scale = LargestEntry(matrix);
  return { scale > 0.0 ? matrix / scale : matrix, center };
}

}
