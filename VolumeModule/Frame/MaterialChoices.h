#ifndef Varimarch_Frame_MaterialChoices_h
#define Varimarch_Frame_MaterialChoices_h

#include "Frame/Frame.h"

class vtkDataArray;
class vtkDataSet;
class vtkVariationFieldVolumeMapper;
class vtkVolumeProperty;

namespace varimarch
{

/// What components, transfer functions and mask make of the settings, whose blend mode is chosen.
/// @throws std::runtime_error a sentence, when the components are nothing that can be drawn
void ChooseMaterial(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataArray* scalars, RenderSettings& settings);

/// The channels and the mask of a frame whose settings are chosen.
/// @throws std::runtime_error a sentence, when something of them is missing
void ChooseVoxels(vtkVariationFieldVolumeMapper* mapper, vtkDataSet* data, Frame& frame);

/// For isosurfaces: of several components leaves, as in VTK, the first of the largest weight.
/// @throws std::runtime_error a sentence, when the components depend on each other
void ChooseSurfaceComponent(Frame& frame);

}

#endif
