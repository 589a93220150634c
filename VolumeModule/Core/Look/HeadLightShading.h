#ifndef Varimarch_Core_Look_HeadLightShading_h
#define Varimarch_Core_Look_HeadLightShading_h

#include "Core/Reference/ReferenceScene.h"

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
/// surface are lit, and where the gradient vanishes, or a voxel beside the cell is not finite, only
/// ambient light is left.
///
/// In a cell each component of the gradient is a cubic along the ray, as the value is. Where the
/// ray grazes a surface, a root of their product with its direction, the light has a kink.
class HeadLightShading
{
public:
  using GradientsFunction = std::function<std::array<CellCorners, 3>(glm::ivec3 cell)>;

  /// @param gradientsOfCell  per voxel, any factor: GradientsOfCell of a grid
  HeadLightShading(
    HeadLight light, GradientsFunction gradientsOfCell, const glm::dmat3& worldFromGridDirection);

  PieceLight operator()(const CellPart& part, const Ray& rayGrid) const;

private:
  HeadLight light;
  GradientsFunction gradientsOfCell;
  glm::dmat3 worldFromGridDirection;
  glm::dmat3 worldFromGridNormal;
};

}

#endif
