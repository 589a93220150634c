#ifndef Varimarch_Scene_SliceNumber_h
#define Varimarch_Scene_SliceNumber_h

#include "Scene/SlicePicture.h"

#include <array>
#include <optional>

class vtkImageData;

namespace varimarch
{

/// Which of the slices of an image is shown.
struct SliceNumber
{
  int number; ///< from 1, in the order of the voxels
  int count;
};

/// The slice through a point in world space [mm], limited to the image. Empty if the image's axes
/// are oblique to the plane, which then cuts several of its slices.
std::optional<SliceNumber> SliceNumberAt(
  vtkImageData* image, SlicePlane plane, const std::array<double, 3>& pointMm);

/// The distance between neighbouring slices [mm]: the spacing of the axis that is nearest to the
/// plane's normal.
double SliceStepMm(vtkImageData* image, SlicePlane plane);

}

#endif
