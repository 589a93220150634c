#include "Scene/Volumes/VariationImage.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

VariationField FieldOf(vtkImageData* image, double tolerance, VoxelDistance distance)
{
  const int* const size = image->GetDimensions();
  const glm::ivec3 dimensions(size[0], size[1], size[2]);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return BuildVariationField(
      ScalarGrid<VTK_TT>(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), dimensions), tolerance,
      distance));
  }
  throw std::invalid_argument("A variation field needs a volume of numbers");
}

}

vtkSmartPointer<vtkImageData> VariationImage(
  vtkImageData* image, double tolerance, VoxelDistance distance)
{
  const int components = image->GetNumberOfScalarComponents();
  if (components != 1)
  {
    throw std::invalid_argument("A variation field needs a volume of one component, found " +
      std::to_string(components) + " components");
  }
  const VariationField field = FieldOf(image, tolerance, distance);
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(field.voxels.begin(), field.voxels.end(),
    static_cast<unsigned char*>(result->GetScalarPointer()));
  return result;
}

}
