#ifndef Varimarch_Scene_VolumeProperty_h
#define Varimarch_Scene_VolumeProperty_h

#include "Scene/Scene.h"

class vtkImageData;
class vtkVolumeProperty;

namespace varimarch
{

class ImageStatistics;

/// Converts a look's values to units of the data. A look whose domain is Data is returned
/// unchanged; others are resolved for this volume. Hounsfield units are left if the values can be
/// such, or if no others are found that stand for them.
Look InUnitsOfData(const Look& look, vtkImageData* image);
Look InUnitsOfData(const Look& look, const ImageStatistics& statistics);

/// True unless a look is in Hounsfield units and the volume has neither these nor values that stand
/// for them.
bool Suits(const Look& look, const ImageStatistics& statistics);

/// Mean spacing of the voxels [mm]. VTK measures gradients in units of the data per mean spacing.
double MeanSpacingMm(vtkImageData* image);

/// Copies the curves, surfaces and coefficients of a look, whose domain must be Data, to a
/// property.
void ApplyLook(const Look& look, double meanSpacingMm, vtkVolumeProperty* property);

/// Copies the coefficients of the light alone.
void ApplyShading(const Shading& shading, vtkVolumeProperty* property);

}

#endif
