#ifndef Varimarch_Frame_MaterialChoices_h
#define Varimarch_Frame_MaterialChoices_h

#include "Frame/Frame.h"

class vtkDataArray;
class vtkDataSet;
class vtkVariationFieldVolumeMapper;
class vtkVolumeProperty;

namespace varimarch
{

class NumberCheck;
struct MapperNumbers;

/// Chooses the settings that depend on components, transfer functions and mask. Requires the blend
/// mode.
/// @throws std::runtime_error with a sentence for the user, if the components cannot be drawn
void ChooseMaterial(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataArray* scalars, RenderSettings& settings);

/// Chooses the components and the mask of a frame. Requires its settings.
/// @throws std::runtime_error with a sentence for the user, if one of them is missing
void ChooseVoxels(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  vtkDataSet* data, Frame& frame);

/// Takes the numbers of a property.
void TakeProperty(vtkVolumeProperty* property, NumberCheck& check, MaterialRequest& material);

/// Chooses how matter takes light, scatters it and reflects it. Requires settings and geometry.
void ChooseLight(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame);

/// Chooses the component of isosurfaces: as in VTK, the first one with the largest weight.
/// @throws std::runtime_error with a sentence for the user, if the components depend on each other
void ChooseSurfaceComponent(Frame& frame);

/// Chooses the isosurfaces or the slice of a frame, if it shows any. Requires its settings,
/// geometry and components.
/// @return false if the frame asks for surfaces, but for none in particular
/// @throws std::invalid_argument or std::runtime_error with a sentence for the user, if they cannot
/// be drawn
bool ChooseSurfaces(vtkVolumeProperty* property, Frame& frame);

}

#endif
