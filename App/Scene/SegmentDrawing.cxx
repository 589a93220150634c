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

/// Value in a mask of the voxels that scissors remove. VTK's mapper expects labels without gaps.
int RemovedNumber(const LabelMap& labels)
{
  return int(labels.segments.size()) + 1;
}

vtkSmartPointer<vtkPiecewiseFunction> Constant(double value)
{
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AddPoint(0.0, value);
  return function;
}

// The opacity of a unit distance of a segment whose mean thickness has the given opacity. A voxel
// lets at least a level of 8 bits through: the steps along rays would have to be far shorter in
// front of an edge that is harder than that.
double OpacityOfUnitDistance(
  double opacity, double thicknessMm, vtkImageData* image, double unitDistanceMm)
{
  constexpr double LeastTransmittance = 1.0 / 256.0;
  const double* const spacing = image->GetSpacing();
  const double most = -std::log(LeastTransmittance) / *std::min_element(spacing, spacing + 3);
  const double extinction = thicknessMm > 0.0 ? -std::log1p(-opacity) / thicknessMm : 0.0;
  return -std::expm1(-std::min(extinction, most) * unitDistanceMm);
}

void ApplyOwnFunctions(
  int number, const Segment& segment, double opacity, vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, segment.rgb.r, segment.rgb.g, segment.rgb.b);
  property->SetLabelColor(number, color);
  property->SetLabelScalarOpacity(number, Constant(opacity));
  if (property->HasGradientOpacity())
  {
    property->SetLabelGradientOpacity(number, Constant(1.0));
  }
}

// Labels without functions of their own would change the rows of the mask, and so its upload. A
// label cannot have a function of two values.
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
      const double opacity = OpacityOfUnitDistance(segments[i].opacity, labels.sizes[i].thicknessMm,
        labels.image, property->GetScalarOpacityUnitDistance());
      ApplyOwnFunctions(int(i + 1), segments[i], opacity, property);
    }
    else if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_2D)
    {
      ApplyFunctionsOfLook(int(i + 1), property);
    }
  }
  ApplyFunctionsOfLook(RemovedNumber(labels), property);
  property->SetLabelScalarOpacity(RemovedNumber(labels), Constant(0.0));
}

void ApplySegmentsByNumber(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property)
{
  constexpr double UnitDistanceMm = 1.0;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(RemovedNumber(labels), 0.0);
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment& segment = segments[i];
    const double ofDistance = segment.visible
      ? OpacityOfUnitDistance(
          segment.opacity, labels.sizes[i].thicknessMm, labels.image, UnitDistanceMm)
      : 0.0;
    color->AddRGBPoint(double(i + 1), segment.rgb.r, segment.rgb.g, segment.rgb.b);
    opacity->AddPoint(double(i + 1), ofDistance);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(UnitDistanceMm);
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
  const auto removed = static_cast<unsigned char>(RemovedNumber(labels));
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
          row[x] = keptRow[coarser[0][x]] ? row[x] : removed;
        }
      }
    });
  return mask;
}

}
