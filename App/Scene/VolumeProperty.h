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

/// Gives a property the curves and coefficients of a look whose domain is Data.
void ApplyLook(const Look& look, vtkVolumeProperty* property);

}

#endif
