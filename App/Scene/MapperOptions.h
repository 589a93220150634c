#ifndef Varimarch_Scene_MapperOptions_h
#define Varimarch_Scene_MapperOptions_h

#include "Scene/Scene.h"

class vtkImageData;
class vtkVolumeMapper;

namespace varimarch
{

/// Gives the options of a scene to a mapper of any MapperKind. VTK's mappers take those that they
/// know.
/// @param image  the volume that the mapper draws
void Apply(const RenderOptions& options, vtkImageData* image, vtkVolumeMapper* mapper);

}

#endif
