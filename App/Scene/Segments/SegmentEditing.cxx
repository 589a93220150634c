#include "Scene/Segments/SegmentEditing.h"

#include "Scene/Model/WorldVector.h"
#include "Scene/Segments/BodyMask.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double Mm3OfMl = 1000.0;

std::uint8_t* NumbersIn(vtkImageData* numbers)
{
  return static_cast<std::uint8_t*>(numbers->GetScalarPointer());
}

// Visits the rows of a box: the first voxel of each in the image and in the box, and their count.
template <class Visit>
void ForEachRowOf(const std::array<int, 6>& box, vtkImageData* numbers, const Visit& visit)
{
  const int* const size = numbers->GetDimensions();
  const std::size_t length = std::size_t(box[1] - box[0] + 1);
  std::size_t inBox = 0;
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y, inBox += length)
    {
      visit((std::size_t(z) * size[1] + y) * size[0] + box[0], inBox, length);
    }
  }
}

std::vector<std::uint8_t> NumbersInBox(const std::array<int, 6>& box, vtkImageData* numbers)
{
  std::vector<std::uint8_t> values(
    std::size_t(box[1] - box[0] + 1) * (box[3] - box[2] + 1) * std::size_t(box[5] - box[4] + 1));
  ForEachRowOf(box, numbers,
    [&](std::size_t inImage, std::size_t inBox, std::size_t length)
    { std::copy_n(NumbersIn(numbers) + inImage, length, values.begin() + inBox); });
  return values;
}

// Grows by what is added to it.
class VoxelBox
{
public:
  void Add(int x, int y, int z)
  {
    const int place[] = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->box[2 * axis] = this->any ? std::min(this->box[2 * axis], place[axis]) : place[axis];
      this->box[2 * axis + 1] =
        this->any ? std::max(this->box[2 * axis + 1], place[axis]) : place[axis];
    }
    this->any = true;
  }

  bool any = false;
  std::array<int, 6> box = {};
};

// Visits the voxels of a box, x fastest: their offset in the image, and their place.
template <class Visit>
void ForEachVoxelOf(const std::array<int, 6>& box, vtkImageData* numbers, const Visit& visit)
{
  const int* const size = numbers->GetDimensions();
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      for (int x = box[0]; x <= box[1]; ++x)
      {
        visit((std::size_t(z) * size[1] + y) * size[0] + x, glm::ivec3(x, y, z));
      }
    }
  }
}

// The change of all voxels of a box whose new number differs. Asking for every number twice needs
// no memory beside that of the change.
template <class NewNumber>
LabelChange ChangeIn(
  const std::array<int, 6>& box, vtkImageData* numbers, const NewNumber& newNumber)
{
  const std::uint8_t* const old = NumbersIn(numbers);
  VoxelBox changed;
  ForEachVoxelOf(box, numbers,
    [&](std::size_t voxel, const glm::ivec3& place)
    {
      if (newNumber(voxel, place, old[voxel]) != old[voxel])
      {
        changed.Add(place.x, place.y, place.z);
      }
    });
  if (!changed.any)
  {
    return {};
  }
  LabelChange change = { changed.box, NumbersInBox(changed.box, numbers), {} };
  change.after.reserve(change.before.size());
  ForEachVoxelOf(changed.box, numbers,
    [&](std::size_t voxel, const glm::ivec3& place)
    { change.after.push_back(newNumber(voxel, place, old[voxel])); });
  return change;
}

std::array<int, 6> WholeBox(vtkImageData* numbers)
{
  const int* const size = numbers->GetDimensions();
  return { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
}

// Keeps the voxels of a segment that a filter's output has.
LabelChange Kept(vtkImageData* numbers, int number, vtkImageConnectivityFilter* filter)
{
  filter->Update();
  const auto* const kept =
    static_cast<const RegionNumber*>(filter->GetOutput()->GetScalarPointer());
  return ChangeIn(WholeBox(numbers), numbers,
    [&](std::size_t voxel, const glm::ivec3&, std::uint8_t old)
    { return old == number && kept[voxel] == 0 ? std::uint8_t(0) : old; });
}

glm::dvec3 IndexFrom0(vtkImageData* image, const std::array<double, 3>& pointMm)
{
  glm::dvec3 index;
  image->TransformPhysicalPointToContinuousIndex(pointMm.data(), &index.x);
  const int* const extent = image->GetExtent();
  return index - glm::dvec3(extent[0], extent[2], extent[4]);
}

// Half of the distance between slices along a normal [mm].
double HalfSliceMm(vtkImageData* image, const glm::dvec3& normal)
{
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 direction;
    for (int row = 0; row < 3; ++row)
    {
      direction[row] = image->GetDirectionMatrix()->GetElement(row, axis);
    }
    half += 0.5 * image->GetSpacing()[axis] * std::abs(glm::dot(direction, normal));
  }
  return half;
}

// The voxels whose middle may lie within a stroke.
std::array<int, 6> BoxOf(const BrushStroke& stroke, vtkImageData* numbers)
{
  const glm::dvec3 from = IndexFrom0(numbers, stroke.fromMm);
  const glm::dvec3 to = IndexFrom0(numbers, stroke.toMm);
  const int* const size = numbers->GetDimensions();
  const double reachMm = stroke.radiusMm + HalfSliceMm(numbers, VectorOf(stroke.normal));
  std::array<int, 6> box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double reach = reachMm / numbers->GetSpacing()[axis];
    box[2 * axis] = std::max(0, int(std::floor(std::min(from[axis], to[axis]) - reach)));
    box[2 * axis + 1] =
      std::min(size[axis] - 1, int(std::ceil(std::max(from[axis], to[axis]) + reach)));
  }
  return box;
}

// True for voxels in the slice whose middle lies within the radius of the stroke's line.
class StrokeTest
{
public:
  StrokeTest(vtkImageData* numbers, const BrushStroke& stroke)
    : numbers(numbers)
    , from(VectorOf(stroke.fromMm))
    , line(VectorOf(stroke.toMm) - from)
    , normal(VectorOf(stroke.normal))
    , radiusMm(stroke.radiusMm)
    , halfSliceMm(HalfSliceMm(numbers, normal))
  {
  }

  bool Holds(const glm::ivec3& voxel) const
  {
    const int* const extent = this->numbers->GetExtent();
    glm::dvec3 place;
    this->numbers->TransformIndexToPhysicalPoint(
      voxel.x + extent[0], voxel.y + extent[2], voxel.z + extent[4], &place.x);
    const glm::dvec3 offset = place - this->from;
    const double height = glm::dot(offset, this->normal);
    const glm::dvec3 flat = offset - height * this->normal;
    const double length2 = glm::dot(this->line, this->line);
    const double part =
      length2 > 0.0 ? glm::clamp(glm::dot(flat, this->line) / length2, 0.0, 1.0) : 0.0;
    // The voxels on one side of a slice between two layers belong to it.
    return height > -this->halfSliceMm && height <= this->halfSliceMm &&
      glm::length(flat - part * this->line) <= this->radiusMm;
  }

private:
  vtkImageData* numbers;
  glm::dvec3 from;
  glm::dvec3 line;
  glm::dvec3 normal;
  double radiusMm;
  double halfSliceMm;
};

}

void Apply(const LabelChange& change, bool isForward, vtkImageData* numbers)
{
  if (change.IsEmpty())
  {
    return;
  }
  const std::vector<std::uint8_t>& values = isForward ? change.after : change.before;
  ForEachRowOf(change.box, numbers,
    [&](std::size_t inImage, std::size_t inBox, std::size_t length)
    { std::copy_n(values.begin() + inBox, length, NumbersIn(numbers) + inImage); });
  numbers->GetPointData()->GetScalars()->Modified();
  numbers->Modified();
}

LabelChange Joined(const LabelChange& first, const LabelChange& second, vtkImageData* numbers)
{
  if (first.IsEmpty() || second.IsEmpty())
  {
    return first.IsEmpty() ? second : first;
  }
  VoxelBox both;
  for (const LabelChange* const change : { &first, &second })
  {
    both.Add(change->box[0], change->box[2], change->box[4]);
    both.Add(change->box[1], change->box[3], change->box[5]);
  }
  LabelChange joined = { both.box, {}, NumbersInBox(both.box, numbers) };
  // The numbers before are those after, with both changes taken back, the last one first.
  vtkNew<vtkImageData> copy;
  copy->SetDimensions(
    both.box[1] - both.box[0] + 1, both.box[3] - both.box[2] + 1, both.box[5] - both.box[4] + 1);
  copy->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(joined.after.begin(), joined.after.end(), NumbersIn(copy));
  for (const LabelChange* const change : { &second, &first })
  {
    LabelChange moved = *change;
    for (int side = 0; side < 6; ++side)
    {
      moved.box[side] -= both.box[side / 2 * 2];
    }
    Apply(moved, false, copy);
  }
  joined.before.assign(NumbersIn(copy), NumbersIn(copy) + joined.after.size());
  return joined;
}

LabelChange ConnectedRegion(vtkImageData* numbers, int number, vtkImageData* scan,
  const std::array<double, 3>& pointMm, const std::array<double, 2>& range)
{
  const auto filter = NewConnectivity(scan, range[0], range[1]);
  const glm::dvec3 index = glm::round(IndexFrom0(scan, pointMm));
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(&index.x);
  vtkNew<vtkPolyData> seed;
  seed->SetPoints(points);
  filter->SetSeedData(seed);
  filter->SetExtractionModeToSeededRegions();
  filter->Update();
  const auto* const found =
    static_cast<const RegionNumber*>(filter->GetOutput()->GetScalarPointer());
  return ChangeIn(WholeBox(numbers), numbers,
    [&](std::size_t voxel, const glm::ivec3&, std::uint8_t old)
    { return old == 0 && found[voxel] != 0 ? std::uint8_t(number) : old; });
}

LabelChange Painted(vtkImageData* numbers, int number, const BrushStroke& stroke)
{
  const StrokeTest test(numbers, stroke);
  return ChangeIn(BoxOf(stroke, numbers), numbers,
    [&](std::size_t, const glm::ivec3& voxel, std::uint8_t old)
    { return test.Holds(voxel) ? std::uint8_t(number) : old; });
}

LabelChange Erased(vtkImageData* numbers, int number, const BrushStroke& stroke)
{
  const StrokeTest test(numbers, stroke);
  return ChangeIn(BoxOf(stroke, numbers), numbers,
    [&](std::size_t, const glm::ivec3& voxel, std::uint8_t old)
    { return old == number && test.Holds(voxel) ? std::uint8_t(0) : old; });
}

LabelChange LargestIsland(vtkImageData* numbers, int number)
{
  const auto filter = NewConnectivity(numbers, number, number);
  filter->SetExtractionModeToLargestRegion();
  return Kept(numbers, number, filter);
}

LabelChange WithoutSmallIslands(vtkImageData* numbers, int number, double leastMl)
{
  const double* const spacing = numbers->GetSpacing();
  const double voxelMm3 = spacing[0] * spacing[1] * spacing[2];
  const auto filter = NewConnectivity(numbers, number, number);
  filter->SetExtractionModeToAllRegions();
  filter->SetSizeRange(vtkIdType(std::ceil(leastMl * Mm3OfMl / voxelMm3)), VTK_ID_MAX);
  return Kept(numbers, number, filter);
}

LabelChange Smoothed(vtkImageData* numbers, int number, double deviationMm)
{
  constexpr float Inside = 1.0F;
  vtkNew<vtkImageData> inside;
  inside->SetDimensions(numbers->GetDimensions());
  inside->AllocateScalars(VTK_FLOAT, 1);
  auto* const values = static_cast<float*>(inside->GetScalarPointer());
  std::transform(NumbersIn(numbers), NumbersIn(numbers) + numbers->GetNumberOfPoints(), values,
    [number](std::uint8_t old) { return old == number ? Inside : 0.0F; });
  const double* const spacing = numbers->GetSpacing();
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(inside);
  smooth->SetStandardDeviations(
    deviationMm / spacing[0], deviationMm / spacing[1], deviationMm / spacing[2]);
  smooth->SetRadiusFactors(3.0, 3.0, 3.0);
  smooth->Update();
  const auto* const smoothed = static_cast<const float*>(smooth->GetOutput()->GetScalarPointer());
  return ChangeIn(WholeBox(numbers), numbers,
    [&](std::size_t voxel, const glm::ivec3&, std::uint8_t old)
    {
      const bool isInside = smoothed[voxel] > 0.5F * Inside;
      return old == 0 && isInside    ? std::uint8_t(number)
        : old == number && !isInside ? std::uint8_t(0)
                                     : old;
    });
}

}
