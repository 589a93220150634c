#ifndef Varimarch_Scene_SceneCamera_h
#define Varimarch_Scene_SceneCamera_h

#include "Scene/Scene.h"

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

/// Unit vector in world space from the eye to the focal point.
std::array<double, 3> ViewDirection(const Camera& camera);

}

#endif
