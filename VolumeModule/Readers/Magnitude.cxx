#include "Readers/Magnitude.h"

#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

namespace varimarch
{
namespace
{

template <class Component, class Result>
void Convert(const Component* components, int count, std::size_t voxelCount, Result* results)
{
  for (std::size_t voxel = 0; voxel < voxelCount; ++voxel)
  {
    double sum = 0.0;
    for (int i = 0; i < count; ++i, ++components)
    {
      sum += double(*components) * double(*components);
    }
    results[voxel] = Result(std::sqrt(sum));
  }
}

}

void TakeMagnitude(const std::string& reason, Volume& volume)
{
  vtkImageData* image = volume.image;
  const bool isShort = image->GetScalarSize() <= 2 || image->GetScalarType() == VTK_FLOAT;
  const int* dimensions = image->GetDimensions();
  auto result = AllocatedImage(
    { { dimensions[0], dimensions[1], dimensions[2] }, isShort ? VTK_FLOAT : VTK_DOUBLE });
  const int count = image->GetNumberOfScalarComponents();
  const auto voxelCount = std::size_t(image->GetNumberOfPoints());
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(
      const auto* components = static_cast<VTK_TT*>(image->GetScalarPointer()); isShort
        ? Convert(components, count, voxelCount, static_cast<float*>(result->GetScalarPointer()))
        : Convert(components, count, voxelCount, static_cast<double*>(result->GetScalarPointer())));
  }
  result->SetOrigin(image->GetOrigin());
  result->SetSpacing(image->GetSpacing());
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  volume.image = result;
  volume.warnings.push_back(reason + ", of which the magnitude was read.");
}

}
