#include "Scene/SegmentDrawing.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

/// Value in a mask of the voxels that scissors remove.
constexpr int Removed = MostLabels + 1;

vtkSmartPointer<vtkPiecewiseFunction> Constant(double value)
{
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AddPoint(0.0, value);
  return function;
}

// The opacity of a unit distance of a segment whose mean thickness has the given opacity.
double OpacityOfUnitDistance(double opacity, double thicknessMm, double unitDistanceMm)
{
  return thicknessMm > 0.0 ? 1.0 - std::pow(1.0 - opacity, unitDistanceMm / thicknessMm) : 0.0;
}

void ApplyOwnFunctions(
  int number, const Segment& segment, double thicknessMm, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, segment.rgb.r, segment.rgb.g, segment.rgb.b);
  property->SetLabelColor(number, color);
  property->SetLabelScalarOpacity(number,
    Constant(OpacityOfUnitDistance(
      segment.opacity, thicknessMm, property->GetScalarOpacityUnitDistance())));
  if (property->HasGradientOpacity())
  {
    property->SetLabelGradientOpacity(number, Constant(1.0));
  }
}

// Labels without functions of their own would change the rows of the mask, and so its upload.
void ApplyFunctionsOfLook(int number, vtkVolumeProperty* property)
{
  property->SetLabelColor(number, property->GetRGBTransferFunction());
  property->SetLabelScalarOpacity(number, property->GetScalarOpacity());
  if (property->HasGradientOpacity())
  {
    property->SetLabelGradientOpacity(number, property->GetGradientOpacity());
  }
}

// For each voxel along an axis, the voxel of a coarser mask of the same box.
std::vector<vtkIdType> Coarser(int count, int coarseCount)
{
  std::vector<vtkIdType> indices;
  for (int i = 0; i < count; ++i)
  {
    indices.push_back(
      std::min(vtkIdType((i + 0.5) / count * coarseCount), vtkIdType(coarseCount - 1)));
  }
  return indices;
}

}

void ApplySegments(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property)
{
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (segments[i].visible)
    {
      ApplyOwnFunctions(int(i + 1), segments[i], labels.sizes[i].thicknessMm, property);
    }
    else
    {
      ApplyFunctionsOfLook(int(i + 1), property);
    }
  }
  property->SetLabelColor(Removed, property->GetRGBTransferFunction());
  property->SetLabelScalarOpacity(Removed, Constant(0.0));
}

vtkSmartPointer<vtkImageData> LabelMask(const LabelMap& labels, vtkImageData* kept)
{
  if (!kept)
  {
    return labels.image;
  }
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->DeepCopy(labels.image);
  const int* const size = mask->GetDimensions();
  const int* const keptSize = kept->GetDimensions();
  std::array<std::vector<vtkIdType>, 3> coarser;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarser[axis] = Coarser(size[axis], keptSize[axis]);
  }
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  const auto* const isKept = static_cast<const unsigned char*>(kept->GetScalarPointer());
  tbb::parallel_for(0, size[2],
    [&](int z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        unsigned char* const row = voxels + (vtkIdType(z) * size[1] + y) * size[0];
        const unsigned char* const keptRow =
          isKept + (coarser[2][z] * keptSize[1] + coarser[1][y]) * keptSize[0];
        for (int x = 0; x < size[0]; ++x)
        {
          row[x] = keptRow[coarser[0][x]] ? row[x] : Removed;
        }
      }
    });
  return mask;
}

}
