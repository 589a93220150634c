#include "Scene/BodyMask.h"

#include <vtkImageConnectivityFilter.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageEuclideanDistance.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageShrink3D.h>
#include <vtkImageThreshold.h>
#include <vtkImageThresholdConnectivity.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace varimarch
{

namespace
{

constexpr double SmallestHu = -350.0;     // between fat and foam, also for voxels that are half air
constexpr double SmallestThinHu = -150.0; // thin parts are skin and cartilage
constexpr double ErosionMm = 3.0;         // shells of tables are thinner than twice this
constexpr double FarthestCoreMm = 15.0;   // between what is left of the trunk and of the nose
constexpr double MarginMm = 2.0;          // around the body, so that its surface keeps its gradient
constexpr double OpeningMm = 4.0;      // air behind openings narrower than twice this is enclosed
constexpr double LargestThinMl = 20.0; // an ear is smaller, a shell of a table larger
constexpr double MostVoxels = 4e6;

using Image = vtkSmartPointer<vtkImageData>;

// The same voxels with indices from 0, at the origin. Distances by VTK need that.
Image FromZero(vtkImageData* image)
{
  Image moved = Image::New();
  moved->ShallowCopy(image);
  const int* const size = image->GetDimensions();
  moved->SetExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  moved->SetOrigin(0.0, 0.0, 0.0);
  return moved;
}

// The voxels within an extent; those beyond the image are ones.
Image Within(vtkImageData* set, const std::array<int, 6>& extent)
{
  vtkNew<vtkImageConstantPad> padded;
  padded->SetInputData(set);
  padded->SetConstant(1.0);
  padded->SetOutputWholeExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  padded->Update();
  return FromZero(padded->GetOutput());
}

// A copy of fewer voxels, which are means. The first component only.
Image Coarse(vtkImageData* image)
{
  vtkNew<vtkImageExtractComponents> first;
  first->SetInputData(image);
  first->SetComponents(0);
  vtkNew<vtkImageShrink3D> shrunk;
  shrunk->SetInputConnection(first->GetOutputPort());
  const int* const size = image->GetDimensions();
  const double* const spacing = image->GetSpacing();
  std::array<int, 3> factors;
  double voxels = 2.0 * MostVoxels;
  for (double sideMm = 1.5; voxels > MostVoxels; sideMm *= 1.1)
  {
    voxels = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int most = std::max(size[axis] / 8, 1);
      factors[axis] = std::clamp(int(sideMm / spacing[axis]), 1, most);
      voxels *= double(size[axis]) / factors[axis];
    }
  }
  shrunk->SetShrinkFactors(factors[0], factors[1], factors[2]);
  shrunk->MeanOn();
  shrunk->Update();
  return FromZero(shrunk->GetOutput());
}

// Ones where a value lies in a range, zeros elsewhere.
Image Between(vtkImageData* image, double lower, double upper)
{
  vtkNew<vtkImageThreshold> threshold;
  threshold->SetInputData(image);
  threshold->ThresholdBetween(lower, upper);
  threshold->SetInValue(1.0);
  threshold->SetOutValue(0.0);
  threshold->SetOutputScalarTypeToUnsignedChar();
  threshold->Update();
  return threshold->GetOutput();
}

Image Not(vtkImageData* set)
{
  return Between(set, 0.0, 0.0);
}

// Voxels of both sets, or of any, by std::bit_and or std::bit_or.
template <class Operation>
Image Combined(vtkImageData* a, vtkImageData* b, Operation operation)
{
  Image both = Image::New();
  both->DeepCopy(a);
  auto* const voxels = static_cast<unsigned char*>(both->GetScalarPointer());
  std::transform(voxels, voxels + both->GetNumberOfPoints(),
    static_cast<const unsigned char*>(b->GetScalarPointer()), voxels, operation);
  return both;
}

// The voxels of a set that are farther than this from all others.
Image Eroded(vtkImageData* set, double distanceMm)
{
  vtkNew<vtkImageEuclideanDistance> squaredDistance;
  squaredDistance->SetInputData(set);
  squaredDistance->InitializeOn();
  squaredDistance->ConsiderAnisotropyOn();
  squaredDistance->Update();
  return Between(
    squaredDistance->GetOutput(), distanceMm * distanceMm * (1.0 + 1e-9), VTK_DOUBLE_MAX);
}

Image Dilated(vtkImageData* set, double distanceMm)
{
  return Not(Eroded(Not(set), distanceMm));
}

Image LargestPart(vtkImageData* set)
{
  vtkNew<vtkImageConnectivityFilter> parts;
  parts->SetInputData(set);
  parts->SetScalarRange(1.0, 1.0);
  parts->SetExtractionModeToLargestRegion();
  parts->SetLabelModeToConstantValue();
  parts->SetLabelConstantValue(1);
  parts->SetLabelScalarTypeToUnsignedChar();
  parts->Update();
  return parts->GetOutput();
}

vtkSmartPointer<vtkPolyData> PointsOf(vtkImageData* set)
{
  vtkNew<vtkPoints> points;
  const auto* const voxels = static_cast<const unsigned char*>(set->GetScalarPointer());
  for (vtkIdType voxel = 0; voxel < set->GetNumberOfPoints(); ++voxel)
  {
    if (voxels[voxel] != 0)
    {
      points->InsertNextPoint(set->GetPoint(voxel));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

// The connected parts of a set that share voxels with another set.
Image PartsThatMeet(vtkImageData* set, vtkImageData* other, double mostMl)
{
  const double* const spacing = set->GetSpacing();
  const double most = 1e3 * mostMl / (spacing[0] * spacing[1] * spacing[2]);
  vtkNew<vtkImageConnectivityFilter> parts;
  parts->SetInputData(set);
  parts->SetSeedData(PointsOf(Combined(set, other, std::bit_and<unsigned char>())));
  parts->SetScalarRange(1.0, 1.0);
  parts->SetExtractionModeToSeededRegions();
  parts->SetSizeRange(1, std::max<vtkIdType>(vtkIdType(most), 1));
  parts->SetLabelModeToConstantValue();
  parts->SetLabelConstantValue(1);
  parts->SetLabelScalarTypeToUnsignedChar();
  parts->Update();
  return parts->GetOutput();
}

// The voxels of a set that are connected with the first one.
Image FirstPart(vtkImageData* set)
{
  vtkNew<vtkPoints> seeds;
  seeds->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkImageThresholdConnectivity> part;
  part->SetInputData(set);
  part->SetSeedPoints(seeds);
  part->ThresholdBetween(1.0, 1.0);
  part->ReplaceInOn();
  part->ReplaceOutOn();
  part->SetInValue(1.0);
  part->SetOutValue(0.0);
  part->Update();
  return part->GetOutput();
}

// A set with the voxels that it encloses. A ball that comes from the sides does not reach them. The
// first and the last slice are no sides: there the scan ends in the body.
Image Filled(vtkImageData* set)
{
  const int* const size = set->GetDimensions();
  const double* const spacing = set->GetSpacing();
  const int x = 2 + int(OpeningMm / spacing[0]);
  const int y = 2 + int(OpeningMm / spacing[1]);
  const Image air = Within(Not(set), { -x, size[0] - 1 + x, -y, size[1] - 1 + y, 0, size[2] - 1 });
  const Image outside = Dilated(FirstPart(Eroded(air, OpeningMm)), OpeningMm);
  const Image inside =
    Within(Not(outside), { x, x + size[0] - 1, y, y + size[1] - 1, 0, size[2] - 1 });
  return Combined(set, inside, std::bit_or<unsigned char>());
}

}

bool HasBodyMask(const std::string& modality)
{
  return modality == "CT";
}

vtkSmartPointer<vtkImageData> BodyMask(vtkImageData* image)
{
  // Filters of images know no directions.
  Image plain = Image::New();
  plain->ShallowCopy(image);
  const double none[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  plain->SetDirectionMatrix(none);
  const Image coarse = Coarse(plain);
  const Image eroded = Eroded(Between(coarse, SmallestHu, VTK_DOUBLE_MAX), ErosionMm);
  const Image largest = LargestPart(eroded);
  if (largest->GetScalarRange()[1] == 0.0)
  {
    return nullptr;
  }
  constexpr double AnySize = 1e9;
  const Image cores = PartsThatMeet(eroded, Dilated(largest, FarthestCoreMm), AnySize);
  const Image thick = Dilated(cores, ErosionMm + MarginMm);
  const double* const spacing = coarse->GetSpacing();
  const Image beside = Dilated(thick, 1.01 * std::max({ spacing[0], spacing[1], spacing[2] }));
  const Image dense = Between(coarse, SmallestThinHu, VTK_DOUBLE_MAX);
  const Image thin = PartsThatMeet(
    Combined(dense, Not(thick), std::bit_and<unsigned char>()), beside, LargestThinMl);
  const Image body = Filled(Combined(thick, Dilated(thin, MarginMm), std::bit_or<unsigned char>()));
  body->SetDirectionMatrix(image->GetDirectionMatrix());
  return body;
}

}
