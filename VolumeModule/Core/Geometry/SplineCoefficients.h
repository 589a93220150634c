#ifndef Varimarch_Core_Geometry_SplineCoefficients_h
#define Varimarch_Core_Geometry_SplineCoefficients_h

#include <glm/vec3.hpp>

namespace varimarch
{

/// Number of voxels beyond the corners of its cell on which a value of a cubic spline depends, on
/// each side.
constexpr int SplineReachVoxels = 1;

/// Replaces voxels, in place and on all cores, by the coefficients of the tricubic B-spline through
/// them: the function with continuous second derivatives that has each voxel's value at that voxel.
/// Beyond its faces the grid continues as its mirror image, with the outermost voxels repeated.
/// Positions inside the grid need one coefficient outside it, which therefore equals that of the
/// nearest face.
///
/// Source: Unser, Aldroubi and Eden, "B-spline signal processing: part II" (IEEE Trans. Signal
/// Processing 41(2), 1993), which applies a forward and a backward recursive filter on each axis.
/// @param voxels  dimensions.x * dimensions.y * dimensions.z finite values, x fastest
template <class Value>
void TurnIntoSplineCoefficients(Value* voxels, glm::ivec3 dimensions);

}

#endif
