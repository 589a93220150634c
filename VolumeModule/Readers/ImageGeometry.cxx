#include "Readers/ImageGeometry.h"

#include "Readers/FileError.h"
#include "Readers/VolumeFile.h"

#include <vtkImageData.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstdio>
#include <sstream>

namespace varimarch
{
namespace
{

bool IsFinite(const glm::dvec3& vector)
{
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

std::string Text(const glm::dvec3& vector)
{
  std::ostringstream text;
  text << '(' << vector.x << ", " << vector.y << ", " << vector.z << ')';
  return text.str();
}

}

ImageGeometry InLps(const ImageGeometry& geometry, const glm::dvec3& signs, double mmPerUnit)
{
  ImageGeometry inLps;
  inLps.originMm = signs * geometry.originMm * mmPerUnit;
  for (int axis = 0; axis < 3; ++axis)
  {
    inLps.axesMm[axis] = signs * geometry.axesMm[axis] * mmPerUnit;
  }
  return inLps;
}

void PlaceImage(const std::string& path, const ImageGeometry& geometry, vtkImageData* image)
{
  if (!IsFinite(geometry.originMm))
  {
    FailToRead(path, "a finite origin", Text(geometry.originMm));
  }
  glm::dvec3 spacingMm(0.0);
  glm::dmat3 direction(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 stepMm = geometry.axesMm[axis];
    spacingMm[axis] = glm::length(stepMm);
    // Division needs at least the smallest normal number.
    if (!std::isnormal(spacingMm[axis]))
    {
      FailToRead(path, "a finite voxel spacing above 0",
        "the step " + Text(stepMm) + " along axis " + std::to_string(axis));
    }
    direction[axis] = stepMm / spacingMm[axis];
  }
  // The determinant is the volume spanned by the axes: 1 if orthogonal, 0 if coplanar.
  if (std::abs(glm::determinant(direction)) < 1e-6)
  {
    FailToRead(path, "three axes that span space",
      "the directions " + Text(direction[0]) + " " + Text(direction[1]) + " " + Text(direction[2]));
  }

  image->SetOrigin(geometry.originMm.x, geometry.originMm.y, geometry.originMm.z);
  image->SetSpacing(spacingMm.x, spacingMm.y, spacingMm.z);
  const glm::dmat3 rows = glm::transpose(direction);
  image->SetDirectionMatrix(&rows[0][0]);
}

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
