#ifndef Varimarch_Benchmarks_Comparison_SliceGeometry_h
#define Varimarch_Benchmarks_Comparison_SliceGeometry_h

#include "Core/Geometry/Box.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace varimarch
{

// The proxy geometry of slices: T. Gorkin, "Volume rendering using graphics hardware" (2009),
// slides 16 to 21. A plane is a vector whose dot product with (position, 1) is 0 on it.

using Polygon = std::vector<glm::dvec3>;

/// The part of a plane in a box, convex and in order around its middle; empty if the plane misses
/// the box.
Polygon SlicePolygon(const Box& box, const glm::dvec4& plane);

double AreaOf(const Polygon& polygon);

/// Adds the triangles of a convex polygon, a fan around its middle.
void AddFan(const Polygon& polygon, std::vector<glm::vec3>& triangles);

/// The place of an eye, and where it looks. World space.
struct SliceEye
{
  glm::dvec3 positionWorld;
  glm::dvec3 directionWorld; ///< unit vector
};

/// Planes in the grid, in the order in which the direction meets them, in the middles of layers of
/// equal thickness.
/// @param normalWorld  unit vector
/// @param layerMm      thickness, > 0
std::vector<glm::dvec4> PlanesAlong(const glm::dvec3& normalWorld, double layerMm,
  const Box& boxGrid, const glm::dmat4& worldFromGrid);

/// The axis of the grid that is most nearly along a direction: that of the stack of slices to draw.
int StackAxis(const glm::dvec3& directionWorld, const glm::dmat4& worldFromGrid);

/// The radii [mm] of shells around an eye, nearest first, in the middles of layers of equal
/// thickness, which begin at the eye.
std::vector<double> ShellRadii(
  const glm::dvec3& eyeWorld, double layerMm, const Box& boxGrid, const glm::dmat4& worldFromGrid);

/// Two triangles in the view that cover the pixels of a box, and so those of each shell in it.
std::vector<glm::vec3> CoverOf(const Box& boxGrid, const glm::dmat4& clipFromGrid);

}

#endif
