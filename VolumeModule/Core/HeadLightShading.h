#ifndef Varimarch_Core_HeadLightShading_h
#define Varimarch_Core_HeadLightShading_h

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <functional>

namespace varimarch
{

/// Coefficients times the colour of the light.
struct HeadLight
{
  glm::dvec3 ambient;
  glm::dvec3 diffuse;
  glm::dvec3 specular;
  double specularPower; ///< > 0
};

/// Blinn-Phong shading for ReferenceScene::shade. Light and eye are in one place, both sides of a
/// surface are lit, and where the gradient vanishes only ambient light is left, as the mapper has
/// it.
class HeadLightShading
{
public:
  /// @param gradientGrid  differences per voxel, any factor, at a position in grid space, such as
  ///                      ScalarGrid::Gradient of a grid of unit spacing
  HeadLightShading(HeadLight light, std::function<glm::dvec3(glm::dvec3)> gradientGrid,
    const glm::dmat3& worldFromGridDirection);

  glm::dvec3 operator()(glm::dvec3 rgb, glm::dvec3 positionGrid, glm::dvec3 directionGrid) const;

private:
  HeadLight light;
  std::function<glm::dvec3(glm::dvec3)> gradientGrid;
  glm::dmat3 worldFromGridDirection;
  glm::dmat3 worldFromGridNormal;
};

}

#endif
