#ifndef Varimarch_Scene_SceneCuts_h
#define Varimarch_Scene_SceneCuts_h

#include "Scene/Scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// All planes that a mapper cuts by: those of the box that take anything away, then the others.
std::vector<CutPlane> PlanesOf(const SceneCuts& cuts, vtkImageData* image);

/// The place in the world at parts of the way from the first voxel to the last along each axis.
glm::dvec3 PointAtParts(const glm::dvec3& parts, vtkImageData* image);

/// Of world space, the middle of a volume [mm].
std::array<double, 3> MiddleOf(vtkImageData* image);

/// Moves a face of a box; it stays within the volume and a thousandth of it before its opposite.
/// @param face  as in SceneCuts::box
/// @param part  where to, as in SceneCuts::box
void MoveFace(std::array<double, 6>& box, int face, double part);

/// Where the faces of a volume's box are when the volume takes another form, such as rectified.
/// Those that took nothing away still do not.
/// @param box  as in SceneCuts::box
std::array<double, 6> BoxInOther(
  const std::array<double, 6>& box, vtkImageData* image, vtkImageData* other);

/// How far along a plane's normal the volume lies: from where to where, measured from its middle
/// [mm].
std::array<double, 2> ReachAlong(const std::array<double, 3>& normal, vtkImageData* image);

/// How deep a plane lies in a volume along its normal: 0 where it keeps all of it, 1 where nothing
/// is left.
double DepthOf(const CutPlane& plane, vtkImageData* image);

/// A plane of the same direction at a depth, through a point above or below the volume's middle.
/// @param depth  [0, 1], see DepthOf
CutPlane AtDepth(double depth, const CutPlane& plane, vtkImageData* image);

}

#endif
