#include "PictureOfMapper.h"

#include "vtkVariationFieldVolumeMapper.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Colours from level - window / 2 to level + window / 2 become 0 to 1; a negative window reverses.
glm::dvec2 WindowScaleBias(double window, double level)
{
  constexpr double Narrowest = 1e-6; // of a window: beyond, floats have no colours between
  const double width = std::copysign(std::max(std::abs(window), Narrowest), window);
  return { 1.0 / width, 0.5 - level / width };
}

}

void ChoosePicture(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  const double window = mapper->GetFinalColorWindow();
  const double level = mapper->GetFinalColorLevel();
  frame.settings.windowLevel = window != 1.0 || level != 0.5;
  frame.windowScaleBias = WindowScaleBias(window, level);
  frame.settings.jitter = mapper->GetUseJittering() != 0;
  frame.imageSampleDistance = mapper->GetImageSampleDistance();
}

}
