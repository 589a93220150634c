#include "Core/HeadLightShading.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace varimarch
{

HeadLightShading::HeadLightShading(HeadLight light,
  std::function<glm::dvec3(glm::dvec3)> gradientGrid, const glm::dmat3& worldFromGridDirection)
  : light(light)
  , gradientGrid(std::move(gradientGrid))
  , worldFromGridDirection(worldFromGridDirection)
  , worldFromGridNormal(glm::transpose(glm::inverse(worldFromGridDirection)))
{
}

glm::dvec3 HeadLightShading::operator()(
  glm::dvec3 rgb, glm::dvec3 positionGrid, glm::dvec3 directionGrid) const
{
  // Normals are covectors: their product with a direction is the same in all spaces.
  const glm::dvec3 gradient = this->gradientGrid(positionGrid);
  const double lengths = glm::length(this->worldFromGridNormal * gradient) *
    glm::length(this->worldFromGridDirection * directionGrid);
  const double cosine = lengths > 0.0 ? std::abs(glm::dot(gradient, directionGrid)) / lengths : 0.0;
  return rgb * (this->light.ambient + cosine * this->light.diffuse) +
    std::pow(cosine, this->light.specularPower) * this->light.specular;
}

}
