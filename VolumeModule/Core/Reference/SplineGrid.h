#ifndef Varimarch_Core_Reference_SplineGrid_h
#define Varimarch_Core_Reference_SplineGrid_h

#include <glm/vec3.hpp>

#include <vector>

namespace varimarch
{

/// Voxels and the tricubic spline through them, in double precision. It provides
/// ReferenceScene::material for images with cubic interpolation. Positions are in grid space, as in
/// ScalarGrid, and are clamped to the nearest face.
class SplineGrid
{
public:
  /// @param voxels  finite values, x fastest
  SplineGrid(std::vector<double> voxels, glm::ivec3 dimensions);

  double Value(glm::dvec3 positionGrid) const;

  /// Derivatives along the axes, per voxel.
  glm::dvec3 Gradient(glm::dvec3 positionGrid) const;

private:
  double Sum(glm::dvec3 positionGrid, glm::ivec3 derivatives) const;

  glm::ivec3 dimensions;
  std::vector<double> coefficients;
};

}

#endif
