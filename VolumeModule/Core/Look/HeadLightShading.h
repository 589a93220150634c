#ifndef Varimarch_Core_Look_HeadLightShading_h
#define Varimarch_Core_Look_HeadLightShading_h

#include "Core/Reference/ReferenceScene.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <functional>

namespace varimarch
{

/// A head light: coefficients multiplied by the light's colour.
struct HeadLight
{
  glm::dvec3 ambient;
  glm::dvec3 diffuse;
  glm::dvec3 specular;
  double specularPower; ///< > 0
};

/// Blinn-Phong shading for ReferenceScene::shade. Light and eye are at the same place, and both
/// sides of a surface are lit. Only ambient light remains where the gradient vanishes or a voxel
/// next to the cell is not finite.
///
/// In a cell, each component of the gradient is a cubic along the ray, as the value is. Shading has
/// a kink where the ray grazes a surface, that is, at a root of the dot product of gradient and
/// ray.
class HeadLightShading
{
public:
  using GradientsFunction = std::function<std::array<CellCorners, 3>(glm::ivec3 cell)>;

  /// @param gradientsOfCell  gradients per voxel, times any factor; see GradientsOfCell
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
