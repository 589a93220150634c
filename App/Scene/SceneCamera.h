#ifndef Varimarch_Scene_SceneCamera_h
#define Varimarch_Scene_SceneCamera_h

#include "Scene/Scene.h"

class vtkCamera;

namespace varimarch
{

/// Places a camera as a scene asks for it.
/// @param boundsWorld  of the volume [mm, LPS]: xmin, xmax, ymin, ymax, zmin, zmax
/// @param aspect       width of the picture by its height, > 0
/// The clipping range is left to vtkRenderer::ResetCameraClippingRange.
void PlaceCamera(
  const Camera& placement, const double boundsWorld[6], double aspect, vtkCamera* camera);

CameraPose PoseOf(vtkCamera* camera);

bool operator==(const CameraPose& a, const CameraPose& b);

/// The camera with a projection; what is at the focal point keeps its size in the picture.
Camera WithProjection(const Camera& camera, bool parallel);

/// From the eye to what it looks at, in world space, of length 1.
std::array<double, 3> ViewDirection(const Camera& camera);

}

#endif
