#ifndef Varimarch_Scene_EmptyPicture_h
#define Varimarch_Scene_EmptyPicture_h

#include "Scene/Pipeline/ScenePipeline.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkRenderWindow;

namespace varimarch
{

/// The last frame of a window over its background, in bytes. It changes neither the window nor its
/// camera.
vtkSmartPointer<vtkImageData> BytesOf(vtkRenderWindow* window);

/// The reason why a frame shows nothing of its scene, and what helps, in one sentence without a
/// full stop: no pixel differs from the background by more than a level. Empty if any does.
/// @param bytes     the frame
/// @param pipeline  that drew it
std::string ReasonForNothing(
  vtkImageData* bytes, const ScenePipeline& pipeline, const Scene& scene);

}

#endif
