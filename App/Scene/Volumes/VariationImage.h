#ifndef Varimarch_Scene_VariationImage_h
#define Varimarch_Scene_VariationImage_h

#include "Core/Fields/VariationField.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The field of variations of a volume, see VariationField, as a volume in the same place: bytes
/// with distances in voxels.
/// @param tolerance  E in units of the data
/// @throws std::invalid_argument if the volume has several components, or the tolerance is negative
///   or NaN
vtkSmartPointer<vtkImageData> VariationImage(
  vtkImageData* image, double tolerance, VoxelDistance distance);

}

#endif
