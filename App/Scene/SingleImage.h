#ifndef Varimarch_Scene_SingleImage_h
#define Varimarch_Scene_SingleImage_h

#include "Scene/SliceAxes.h"

#include <optional>

class vtkImageData;

namespace varimarch
{

/// The slice that shows a single image, such as a radiograph: an anatomical plane, and the turn
/// that lays it into the plane of the image.
struct SingleImage
{
  SlicePlane plane;
  SliceTurn turn;
};

/// Empty for a volume of several slices.
std::optional<SingleImage> SingleImageOf(vtkImageData* volume);

/// The turn of the slices when a volume is opened: that of a single image, or else none.
SliceTurn FirstTurnOf(vtkImageData* volume);

}

#endif
