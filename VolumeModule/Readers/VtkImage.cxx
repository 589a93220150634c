#include "Readers/VtkImage.h"

#include "Readers/FileError.h"
#include "Readers/ImageGeometry.h"
#include "Readers/VoxelLayout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <tuple>

namespace varimarch
{
namespace
{

bool IsNumeric(const ImageArray& array)
{
  return IsNumberType(array.scalarType) && !array.name.empty() &&
    array.name != vtkDataSetAttributes::GhostArrayName();
}

ImageGeometry GeometryOf(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  const glm::dvec3 firstIndex(extent[0], extent[2], extent[4]);
  const glm::dmat3 direction =
    glm::transpose(glm::make_mat3(image->GetDirectionMatrix()->GetData()));
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = direction[axis] * image->GetSpacing()[axis];
  }
  // The file's extent may begin anywhere; the output's begins at 0.
  geometry.originMm = glm::make_vec3(image->GetOrigin()) + geometry.axesMm * firstIndex;
  return geometry;
}

}

ImageArray ArrayToShow(const std::string& path, std::vector<ImageArray> arrays)
{
  arrays.erase(std::remove_if(
                 arrays.begin(), arrays.end(), [](const auto& array) { return !IsNumeric(array); }),
    arrays.end());
  if (arrays.empty())
  {
    FailToRead(path, "a numeric array of point or cell data", "none");
  }
  const auto rank = [](const ImageArray& array)
  { return std::tuple(array.isInCells, !array.isActive, array.componentCount > 4); };
  return *std::min_element(arrays.begin(), arrays.end(),
    [&](const ImageArray& a, const ImageArray& b) { return rank(a) < rank(b); });
}

vtkSmartPointer<vtkImageData> VoxelsOf(vtkImageData* image, const ImageArray& array)
{
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (array.isInCells)
  {
    attributes = image->GetCellData();
  }
  vtkDataArray* values = attributes->GetArray(array.name.c_str());
  int extent[6];
  image->GetExtent(extent);
  glm::dvec3 firstCentre(0.0);
  for (int axis = 0; array.isInCells && axis < 3; ++axis)
  {
    // A single layer of points is a single layer of flat cells.
    const bool isThick = extent[2 * axis + 1] > extent[2 * axis];
    extent[2 * axis + 1] -= isThick ? 1 : 0;
    firstCentre[axis] = isThick ? 0.5 : 0.0;
  }
  auto voxels = vtkSmartPointer<vtkImageData>::New();
  voxels->SetExtent(extent);
  if (!values || values->GetNumberOfTuples() != voxels->GetNumberOfPoints())
  {
    return nullptr;
  }
  glm::dvec3 origin;
  image->TransformContinuousIndexToPhysicalPoint(
    firstCentre.x, firstCentre.y, firstCentre.z, &origin[0]);
  voxels->SetOrigin(&origin[0]);
  voxels->SetSpacing(image->GetSpacing());
  voxels->SetDirectionMatrix(image->GetDirectionMatrix());
  voxels->GetPointData()->SetScalars(values);
  return voxels;
}

Volume VolumeOf(const std::string& path, vtkImageData* voxels)
{
  Volume volume;
  volume.image = vtkSmartPointer<vtkImageData>::New();
  volume.image->SetDimensions(voxels->GetDimensions());
  volume.image->GetPointData()->SetScalars(voxels->GetPointData()->GetScalars());
  PlaceImage(path, GeometryOf(voxels), volume.image);
  return volume;
}

}
