#ifndef Varimarch_Frame_RendererVolumes_h
#define Varimarch_Frame_RendererVolumes_h

#include "vtkType.h"

#include <vector>

class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// The mapper that draws a volume: its own, or that inside a
/// vtkVariationFieldGPUVolumeRayCastMapper, which may leave the volume to VTK; null for others.
vtkVariationFieldVolumeMapper* DrawingMapper(vtkVolume* volume);

/// Chooses the mapper for the next frame of a volume with a DrawingMapper. True for VTK's own.
bool IsLeftToVtk(vtkVolume* volume, vtkRenderer* renderer);

/// The visible volumes of a renderer that have a DrawingMapper, sorted by the
/// distance of their centres from the camera, farthest first, and at the same distance by the size
/// of their boxes, largest first. The order does not depend on that in which they were added.
std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer);

/// The time of the last change that may affect their order or their visibility.
vtkMTimeType TimeOf(const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer);

}

#endif
