#ifndef Varimarch_Scene_VolumeProperty_h
#define Varimarch_Scene_VolumeProperty_h

#include "Scene/Scene.h"

class vtkImageData;
class vtkVolumeProperty;

namespace varimarch
{

class ImageStatistics;

/// The look with its values in the units of the data: itself, or for a relative one what it means
/// for this volume.
Look InUnitsOfData(const Look& look, vtkImageData* image);
Look InUnitsOfData(const Look& look, const ImageStatistics& statistics);

/// Mean distance of neighbouring voxels [mm]. VTK measures gradients in units of the data per this.
double MeanSpacingMm(vtkImageData* image);

/// Gives a property the curves, surfaces and coefficients of a look whose domain is Data.
void ApplyLook(const Look& look, double meanSpacingMm, vtkVolumeProperty* property);

}

#endif
