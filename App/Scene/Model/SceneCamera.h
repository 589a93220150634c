#ifndef Varimarch_Scene_SceneCamera_h
#define Varimarch_Scene_SceneCamera_h

#include "Scene/Model/Scene.h"

class vtkCamera;

namespace varimarch
{

/// Places a vtkCamera as the scene's camera describes. Call vtkRenderer::ResetCameraClippingRange
/// afterwards for the clipping range.
/// @param boundsWorld  of the volume [mm, LPS]: xmin, xmax, ymin, ymax, zmin, zmax
/// @param aspect       width of the image divided by its height, > 0
void PlaceCamera(
  const Camera& placement, const double boundsWorld[6], double aspect, vtkCamera* camera);

CameraPose PoseOf(vtkCamera* camera);

bool operator==(const CameraPose& a, const CameraPose& b);

/// The camera with the other projection. Objects at the focal point keep their size in the image.
Camera WithProjection(const Camera& camera, bool parallel);

/// The smallest and the largest distance of a box from the eye, along the viewing direction [mm].
/// @param least  lower limit of both, for an eye in the box or beyond it
std::array<double, 2> DepthRangeMm(const Camera& camera, const double boundsWorld[6], double least);

/// Unit vector in world space from the eye to the focal point.
std::array<double, 3> ViewDirection(const Camera& camera);

}

#endif
