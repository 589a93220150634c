#ifndef Varimarch_Scene_VolumeColors_h
#define Varimarch_Scene_VolumeColors_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The component of ColoredVoxels that opacities depend on.
constexpr int AlphaComponent = 3;

/// The voxels of an image whose components are colours, as bytes of red, green, blue and alpha.
/// Numbers of other types are divided by the largest number of all components. Alpha is that of the
/// image, or the luminance if the image has none, or the same everywhere. An image that holds no
/// colours is returned as it is.
vtkSmartPointer<vtkImageData> ColoredVoxels(vtkImageData* image);

}

#endif
