#ifndef Varimarch_Frame_MaterialChoices_h
#define Varimarch_Frame_MaterialChoices_h

#include "Frame/Frame.h"

class vtkDataArray;
class vtkDataSet;
class vtkVariationFieldVolumeMapper;
class vtkVolumeProperty;

namespace varimarch
{

/// Chooses the settings that depend on components, transfer functions and mask. The blend mode is
/// already chosen.
/// @throws std::runtime_error a sentence, if the components cannot be drawn
void ChooseMaterial(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataArray* scalars, RenderSettings& settings);

/// Chooses the components and the mask of a frame whose settings are chosen.
/// @throws std::runtime_error a sentence, if one of them is missing
void ChooseVoxels(vtkVariationFieldVolumeMapper* mapper, vtkDataSet* data, Frame& frame);

/// Leaves one component for isosurfaces: as in VTK the first with the largest weight.
/// @throws std::runtime_error a sentence, if the components depend on each other
void ChooseSurfaceComponent(Frame& frame);

}

#endif
