#ifndef Varimarch_Scene_SceneCuts_h
#define Varimarch_Scene_SceneCuts_h

#include "Scene/Model/Scene.h"

#include <vtkSmartPointer.h>

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

/// Binary mask for a mapper: 1 where the volume stays, 0 where a cut removes it. It covers the
/// volume's box at the volume's resolution, or coarser by a whole factor beyond about 16 million
/// voxels. Null without cuts and a body.
/// @param body  the part that stays before the cuts, see BodyMask.h; null for all
vtkSmartPointer<vtkImageData> MaskOf(
  const std::vector<ScissorsCut>& cuts, vtkImageData* image, vtkImageData* body = nullptr);

/// True if a mask keeps a point of the volume. A null mask keeps everything.
/// @param index  continuous index of the point, within the image
bool Keeps(vtkImageData* mask, vtkImageData* image, const glm::dvec3& index);

/// The mask of what two masks of an image keep, on the grid of the first; the other mask if one is
/// null.
vtkSmartPointer<vtkImageData> Both(vtkImageData* fine, vtkImageData* other, vtkImageData* image);

/// A copy of a volume whose voxels have the smallest value wherever a mask keeps nothing.
vtkSmartPointer<vtkImageData> WithoutRemoved(vtkImageData* image, vtkImageData* mask);

bool operator==(const ScissorsCut& a, const ScissorsCut& b);

}

#endif
