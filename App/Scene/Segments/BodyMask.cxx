#include "Scene/Segments/BodyMask.h"

#include "Scene/Volumes/ImageStatistics.h"

#include <vtkDataArray.h>
#include <vtkImageConnectivityFilter.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageEuclideanDistance.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageShrink3D.h>
#include <vtkImageThreshold.h>
#include <vtkImageThresholdConnectivity.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

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

namespace
{

constexpr double AirOfFaceHu = -500.0;
constexpr double SkinHu = -300.0;
constexpr double SkinPart = 0.15; // a part of the range of values without a unit
constexpr double SmoothingMm = 20.0;
constexpr double FrontPart = 0.5; // a part of the head from front to back
constexpr int Nothing = std::numeric_limits<int>::max();

// The lines of voxels from the front to the back of the patient.
class FrontLines
{
public:
  explicit FrontLines(vtkImageData* image)
  {
    const int* const dimensions = image->GetDimensions();
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double toBack = image->GetDirectionMatrix()->GetElement(1, axis);
      if (std::abs(toBack) > std::abs(largest))
      {
        largest = toBack;
        this->along = axis;
      }
    }
    this->isReversed = largest < 0.0;
    this->beside = { this->along == 0 ? 1 : 0, this->along == 2 ? 1 : 2 };
    std::copy_n(dimensions, 3, this->size.begin());
    std::copy_n(image->GetSpacing(), 3, this->spacing.begin());
  }

  int Length() const { return this->size[this->along]; }
  int Width() const { return this->size[this->beside[0]]; }
  int Height() const { return this->size[this->beside[1]]; }
  double StepMm() const { return this->spacing[this->along]; }
  double BesideMm(int axis) const { return this->spacing[this->beside[axis]]; }

  /// A voxel by its place on a line, from the front.
  std::size_t Voxel(int line, int place) const
  {
    std::array<int, 3> index;
    index[this->along] = this->isReversed ? this->Length() - 1 - place : place;
    index[this->beside[0]] = line % this->Width();
    index[this->beside[1]] = line / this->Width();
    return (std::size_t(index[2]) * this->size[1] + index[1]) * this->size[0] + index[0];
  }

private:
  int along = 1;
  bool isReversed = false;
  std::array<int, 2> beside;
  std::array<int, 3> size;
  std::array<double, 3> spacing;
};

double SkinValue(vtkImageData* image)
{
  const ImageStatistics statistics(image);
  if (statistics.Smallest() <= AirOfFaceHu)
  {
    return SkinHu;
  }
  const double smallest = statistics.Percentile(1.0);
  return smallest + SkinPart * (statistics.Percentile(99.0) - smallest);
}

// Ones in the largest connected part that is denser than air.
vtkSmartPointer<vtkImageData> Head(vtkImageData* image)
{
  const auto largest = NewConnectivity(image, SkinValue(image), VTK_DOUBLE_MAX);
  largest->SetExtractionModeToLargestRegion();
  largest->Update();
  return largest->GetOutput();
}

// The first voxel of the head on each line; Nothing without one.
std::vector<int> Surface(const FrontLines& lines, const RegionNumber* head)
{
  std::vector<int> first(std::size_t(lines.Width()) * lines.Height(), Nothing);
  for (int line = 0; line < int(first.size()); ++line)
  {
    for (int place = 0; place < lines.Length() && first[line] == Nothing; ++place)
    {
      first[line] = head[lines.Voxel(line, place)] ? place : Nothing;
    }
  }
  return first;
}

// The end of the front part of the head; empty without a head.
std::optional<int> FacePlane(
  const std::vector<int>& surface, const FrontLines& lines, const RegionNumber* head)
{
  const int front = *std::min_element(surface.begin(), surface.end());
  if (front == Nothing)
  {
    return std::nullopt;
  }
  int back = front;
  for (int line = 0; line < int(surface.size()); ++line)
  {
    for (int place = lines.Length() - 1; place > back; --place)
    {
      back = head[lines.Voxel(line, place)] ? std::max(back, place) : back;
    }
  }
  return front + int(FrontPart * (back - front));
}

// The deepest surface in front of a plane within the smoothing distance along one axis beside the
// lines.
std::vector<int> Deepest(
  const std::vector<int>& surface, const FrontLines& lines, int axis, int plane)
{
  const int reach = int(std::ceil(SmoothingMm / lines.BesideMm(axis)));
  const int stride = axis == 0 ? 1 : lines.Width();
  const int count = axis == 0 ? lines.Width() : lines.Height();
  std::vector<int> deepest(surface.size(), Nothing);
  for (int line = 0; line < int(surface.size()); ++line)
  {
    const int place = axis == 0 ? line % lines.Width() : line / lines.Width();
    for (int other = std::max(0, place - reach); other <= std::min(count - 1, place + reach);
         ++other)
    {
      const int found = surface[line + (other - place) * stride];
      if (found < plane)
      {
        deepest[line] = deepest[line] == Nothing ? found : std::max(deepest[line], found);
      }
    }
  }
  return deepest;
}

}

vtkSmartPointer<vtkImageData> FaceMask(vtkImageData* image, double depthMm)
{
  const FrontLines lines(image);
  const vtkSmartPointer<vtkImageData> headImage = Head(image);
  const auto* const head = static_cast<const RegionNumber*>(headImage->GetScalarPointer());
  const std::vector<int> surface = Surface(lines, head);
  const std::optional<int> plane = FacePlane(surface, lines, head);
  if (!plane)
  {
    return nullptr;
  }
  const std::vector<int> smooth = Deepest(Deepest(surface, lines, 0, *plane), lines, 1, *plane);
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(image->GetDimensions());
  mask->SetDirectionMatrix(image->GetDirectionMatrix());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mask->GetPointData()->GetScalars()->Fill(1.0);
  auto* const kept = static_cast<unsigned char*>(mask->GetScalarPointer());
  const int depth = int(std::min(std::ceil(depthMm / lines.StepMm()), double(lines.Length())));
  for (int line = 0; line < int(smooth.size()); ++line)
  {
    const int end = smooth[line] == Nothing ? 0 : std::min(smooth[line] + depth, *plane);
    for (int place = 0; place < end; ++place)
    {
      kept[lines.Voxel(line, place)] = 0;
    }
  }
  return mask;
}

vtkSmartPointer<vtkImageConnectivityFilter> NewConnectivity(
  vtkImageData* image, double smallest, double largest)
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(image->GetDimensions());
  plain->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  auto filter = vtkSmartPointer<vtkImageConnectivityFilter>::New();
  filter->SetInputData(plain);
  // VTK's filter rounds the range of whole values towards 0.
  const int type = image->GetScalarType();
  const bool areWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  filter->SetScalarRange(
    areWhole ? std::ceil(smallest) : smallest, areWhole ? std::floor(largest) : largest);
  filter->SetLabelModeToConstantValue();
  filter->SetLabelConstantValue(1);
  filter->SetLabelScalarTypeToUnsignedShort();
  return filter;
}

}
