#include "Scene/SliceGrid.h"

#include "Scene/VoxelIndex.h"
#include "Scene/WorldVector.h"

#include <vtkImageData.h>

namespace varimarch
{

SliceGrid::SliceGrid(vtkImageData* image, const SliceRequest& request)
  : extent(image->GetExtent())
{
  const SliceAxes axes = AxesOf(request.plane, request.turn);
  const glm::dvec3 middle = VectorOf(request.middleMm);
  const glm::dvec3 middleIndex = VoxelIndexOf(middle, image);
  const auto step = [&](const glm::dvec3& directionMm)
  { return VoxelIndexOf(middle + directionMm, image) - middleIndex; };
  this->right = step(request.mmPerPixel * VectorOf(axes.right));
  this->down = step(request.mmPerPixel * VectorOf(axes.down));
  this->throughPerMm = step(VectorOf(axes.through));
  this->first = middleIndex + (0.5 - 0.5 * request.width) * this->right +
    (0.5 - 0.5 * request.height) * this->down;
}

glm::dvec3 SliceGrid::IndexAt(int column, int row) const
{
  return this->first + double(column) * this->right + double(row) * this->down;
}

bool IsWithin(const glm::dvec3& index, const int* extent)
{
  constexpr double Rounding = 1e-6; // a turned plane must not miss the one slice of an image
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(index[axis] >= extent[2 * axis] - Rounding &&
          index[axis] <= extent[2 * axis + 1] + Rounding))
    {
      return false;
    }
  }
  return true;
}

}
