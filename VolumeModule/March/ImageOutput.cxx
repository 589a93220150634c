#include "March/ImageOutput.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

void FillColorImage(const std::vector<float>& rgba, int width, int height, vtkImageData* image)
{
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < rgba.size(); ++i)
  {
    const float white = i % 4 == 3 ? 0.0f : 1.0f - rgba[i | 3];
    bytes[i] =
      static_cast<unsigned char>(std::lround(255.0f * std::clamp(rgba[i] + white, 0.0f, 1.0f)));
  }
}

void FillDepthImage(
  const std::vector<float>& rgba, int width, int height, int scalarType, vtkImageData* image)
{
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* const depths = image->GetPointData()->GetScalars();
  const bool integers = scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE;
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    const double depth = 1.0 - rgba[4 * i];
    depths->SetComponent(i, 0, integers ? std::round(depth * depths->GetDataTypeMax()) : depth);
  }
}

}
