#include "Core/Look/HeadLightShading.h"

#include "Core/Reference/CellPieces.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// Bernstein coefficients of a vector-valued cubic.
using VectorCubic = std::array<glm::dvec3, 4>;

glm::dvec3 ValueOf(const VectorCubic& b, double u)
{
  const double v = 1.0 - u;
  return v * v * v * b[0] + 3.0 * u * v * v * b[1] + 3.0 * u * u * v * b[2] + u * u * u * b[3];
}

glm::dvec3 Lit(const HeadLight& light, glm::dvec3 rgb, double cosine)
{
  return rgb * (light.ambient + cosine * light.diffuse) +
    std::pow(cosine, light.specularPower) * light.specular;
}

/// Parameters in (0, 1) at which a cubic changes sign.
std::vector<double> SignChanges(const CellCubic& cubic)
{
  std::vector<double> roots;
  const CellCubic::Cuts cuts = cubic.MonotoneCuts();
  for (int i = 0; i + 1 < cuts.count; ++i)
  {
    if (cubic.Value(cuts.u[i]) * cubic.Value(cuts.u[i + 1]) < 0.0)
    {
      roots.push_back(cubic.Crossing(0.0, cuts.u[i], cuts.u[i + 1]));
    }
  }
  return roots;
}

}

HeadLightShading::HeadLightShading(
  HeadLight light, GradientsFunction gradientsOfCell, const glm::dmat3& worldFromGridDirection)
  : light(light)
  , gradientsOfCell(std::move(gradientsOfCell))
  , worldFromGridDirection(worldFromGridDirection)
  , worldFromGridNormal(glm::transpose(glm::inverse(worldFromGridDirection)))
{
}

PieceLight HeadLightShading::operator()(const CellPart& part, const Ray& rayGrid) const
{
  const std::array<CellCorners, 3> corners = this->gradientsOfCell(part.cell);
  if (!std::all_of(corners.begin(), corners.end(), AllFinite))
  {
    return { [light = this->light](glm::dvec3 rgb, double) { return Lit(light, rgb, 0.0); } };
  }
  VectorCubic normals;
  for (int axis = 0; axis < 3; ++axis)
  {
    const CellCubic gradient = PieceOf(part, corners[axis], rayGrid).cubic;
    for (int i = 0; i < 4; ++i)
    {
      normals[i][axis] = gradient.Bernstein()[i];
    }
  }
  const glm::dvec3 toEye = glm::normalize(this->worldFromGridDirection * rayGrid.direction);
  std::array<double, 4> towardsEye;
  for (int i = 0; i < 4; ++i)
  {
    normals[i] = this->worldFromGridNormal * normals[i];
    towardsEye[i] = glm::dot(normals[i], toEye);
  }
  const auto emitted = [light = this->light, normals, toEye](glm::dvec3 rgb, double u)
  {
    const glm::dvec3 normal = ValueOf(normals, u);
    const double length = glm::length(normal);
    const double cosine = length > 0.0 ? std::abs(glm::dot(normal, toEye)) / length : 0.0;
    return Lit(light, rgb, std::min(cosine, 1.0));
  };
  return { emitted, SignChanges(CellCubic(towardsEye)) };
}

}
