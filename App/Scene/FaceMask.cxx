#include "Scene/FaceMask.h"

#include "Scene/ConnectedVoxels.h"
#include "Scene/ImageStatistics.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace varimarch
{

namespace
{

constexpr double HighestAirHu = -500.0;
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
  if (statistics.Smallest() <= HighestAirHu)
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

}
