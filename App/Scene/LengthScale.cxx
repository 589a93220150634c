#include "Scene/LengthScale.h"

#include "Readers/ImageFacts.h"
#include "Scene/HounsfieldScale.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double SmallestPartMm = 20.0;
constexpr double LargestBodyMm = 3000.0;

// A voxel is a box about its centre, so that a single slice has a thickness.
std::array<double, 3> SidesMm(vtkImageData* image)
{
  std::array<double, 3> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    sides[axis] = image->GetDimensions()[axis] * std::abs(image->GetSpacing()[axis]);
  }
  return sides;
}

}

bool HasSizeOfPatient(vtkImageData* image, double smallestValue)
{
  const std::array<double, 3> sides = SidesMm(image);
  const double longest = *std::max_element(sides.begin(), sides.end());
  return longest >= SmallestPartMm && longest <= LargestBodyMm &&
    (ShowsPatient(image) || smallestValue <= HighestAirHu);
}

double LengthFactor(vtkImageData* image, double smallestValue)
{
  const std::array<double, 3> sides = SidesMm(image);
  const double side = std::cbrt(sides[0]) * std::cbrt(sides[1]) * std::cbrt(sides[2]);
  const bool isKnown = HasSizeOfPatient(image, smallestValue) || !(side > 0.0);
  return isKnown ? 1.0 : side / BodySideMm;
}

}
