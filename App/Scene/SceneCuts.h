#ifndef Varimarch_Scene_SceneCuts_h
#define Varimarch_Scene_SceneCuts_h

#include "Scene/Scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// All clipping planes for a mapper: those of the box that remove anything, then the free planes.
std::vector<CutPlane> PlanesOf(const SceneCuts& cuts, vtkImageData* image);

/// True if a point in world space [mm] lies on the kept side of all planes.
bool IsKept(const glm::dvec3& pointMm, const std::vector<CutPlane>& planes);

/// World position at the given fractions of the way from the first voxel to the last of each axis.
glm::dvec3 PointAtParts(const glm::dvec3& parts, vtkImageData* image);

/// Centre of a volume in world space [mm].
std::array<double, 3> MiddleOf(vtkImageData* image);

/// Moves a face of a box. The face stays within the volume and at least 0.001 short of the opposite
/// face.
/// @param face  index in SceneCuts::box
/// @param part  new position, as in SceneCuts::box
void MoveFace(std::array<double, 6>& box, int face, double part);

/// Converts a box to another form of the same volume, such as the rectified one. Faces that removed
/// nothing still remove nothing.
/// @param box  as in SceneCuts::box
std::array<double, 6> BoxInOther(
  const std::array<double, 6>& box, vtkImageData* image, vtkImageData* other);

/// The interval that a volume covers along a plane's normal, measured from its centre [mm].
std::array<double, 2> ReachAlong(const std::array<double, 3>& normal, vtkImageData* image);

/// Depth of a plane in a volume along its normal: 0 keeps the whole volume, 1 removes it.
double DepthOf(const CutPlane& plane, vtkImageData* image);

/// A plane of the same direction at another depth. Its point lies on the normal through the
/// volume's centre.
/// @param depth  [0, 1], see DepthOf
CutPlane AtDepth(double depth, const CutPlane& plane, vtkImageData* image);

}

#endif
