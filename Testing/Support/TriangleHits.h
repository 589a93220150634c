#ifndef Varimarch_Testing_TriangleHits_h
#define Varimarch_Testing_TriangleHits_h

#include "Core/Geometry/Box.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>

/// The place at which a ray meets the plane of a triangle.
struct TrueHit
{
  double t =
    std::numeric_limits<double>::infinity(); ///< along the ray, in lengths of its direction
  double inside = 0.0; ///< The least barycentric coordinate; below 0 the triangle is missed.
};

/// Cramer's rule for origin + t direction = first + u (second - first) + v (third - first).
inline TrueHit HitOf(const std::array<glm::dvec3, 3>& triangle, const varimarch::Ray& ray)
{
  const glm::dvec3 a = triangle[1] - triangle[0];
  const glm::dvec3 b = triangle[2] - triangle[0];
  const glm::dvec3 c = ray.origin - triangle[0];
  const double all = glm::dot(glm::cross(a, b), -ray.direction);
  const double u = glm::dot(glm::cross(c, b), -ray.direction) / all;
  const double v = glm::dot(glm::cross(a, c), -ray.direction) / all;
  return { glm::dot(glm::cross(a, b), c) / all, std::min({ u, v, 1.0 - u - v }) };
}

#endif
