#ifndef Varimarch_Core_Geometry_SplineCoefficients_h
#define Varimarch_Core_Geometry_SplineCoefficients_h

#include <glm/vec3.hpp>

namespace varimarch
{

/// A value of a cubic spline depends on the coefficients of its cell's corners, and on so many
/// voxels more to every side.
constexpr int SplineReachVoxels = 1;

/// Turns voxels, in place and on all cores, into the coefficients of the tricubic B-spline through
/// them: the function whose second derivatives are continuous, and that has each voxel's value at
/// the voxel. Beyond its faces the grid goes on as its mirror image, the outermost voxels twice, so
/// that coefficients outside are those of the nearest face for the one step that a position within
/// the grid needs.
///
/// After Unser, Aldroubi and Eden, "B-spline signal processing: part II" (IEEE Trans. Signal
/// Processing 41(2), 1993): on each axis a recursive filter forwards, and one backwards.
/// @param voxels  dimensions.x * dimensions.y * dimensions.z finite values, x fastest
template <class Value>
void TurnIntoSplineCoefficients(Value* voxels, glm::ivec3 dimensions);

}

#endif
