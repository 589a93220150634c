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

/// The visible volumes of a renderer that have a DrawingMapper, in the order in which they are
/// drawn. If a plane separates what cuts leave of two volumes, that beyond the plane comes first.
/// Others are sorted by the distance of the centres of what is left from the camera, farthest
/// first, then by its size, largest first, and at last in the order in which they were added.
std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer);

/// The time of the last change that may affect their order or their visibility.
vtkMTimeType TimeOf(const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer);

}

#endif
