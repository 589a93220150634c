#include "Readers/Images/StackGeometry.h"

#include "Readers/VolumeFile.h"

#include <cstdio>

namespace varimarch
{

ImageGeometry StackGeometry(
  const std::array<double, 3>& spacingMm, int orientation, std::vector<std::string>& warnings)
{
  glm::dvec3 spacing(spacingMm[0], spacingMm[1], spacingMm[2]);
  if (spacing.x == 0.0 || spacing.y == 0.0)
  {
    warnings.push_back(UnknownSpacing);
    spacing = glm::dvec3(1.0);
  }
  else if (spacing.z == 0.0)
  {
    spacing.z = spacing.x;
    char text[160];
    std::snprintf(text, sizeof(text),
      "The distance of the slices is unknown; that of the pixels, %g mm, was assumed.", spacing.x);
    warnings.push_back(text);
  }

  // Directions of rows and columns for each orientation.
  static const glm::dvec3 along[8] = { { 1, 0, 0 }, { -1, 0, 0 }, { -1, 0, 0 }, { 1, 0, 0 },
    { 0, 1, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, -1, 0 } };
  static const glm::dvec3 down[8] = { { 0, 1, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, -1, 0 },
    { 1, 0, 0 }, { -1, 0, 0 }, { -1, 0, 0 }, { 1, 0, 0 } };
  const int row = orientation >= 1 && orientation <= 8 ? orientation - 1 : 0;
  ImageGeometry geometry;
  geometry.axesMm = { along[row] * spacing.x, down[row] * spacing.y, { 0.0, 0.0, spacing.z } };
  return geometry;
}

}
