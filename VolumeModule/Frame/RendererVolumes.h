#ifndef Varimarch_Frame_RendererVolumes_h
#define Varimarch_Frame_RendererVolumes_h

#include "vtkType.h"

#include <vector>

class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The visible volumes of a renderer that vtkVariationFieldVolumeMapper draws, the one first whose
/// middle is farthest from the camera; those as far as each other as they were added.
std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer);

/// When anything last changed that their order, or which of them are in view, depends on.
vtkMTimeType TimeOf(const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer);

}

#endif
