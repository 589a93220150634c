#include "Readers/Rectify.h"

#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace varimarch
{
namespace
{

/// Error of positions that are stored as decimals, in voxels.
constexpr double Tolerance = 1e-3;

/// The grid to resample to, and the positions of the scan's slices in it.
struct EvenGrid
{
  ImageGeometry geometry;
  std::array<std::int64_t, 3> dimensions;
  /// Position of the first voxel of each slice: in voxels along rows and columns, in mm along the
  /// normal.
  std::vector<glm::dvec3> slices;
};

/// One term of a resampled value: a voxel of the scan, relative to a voxel of the grid.
struct Tap
{
  glm::i64vec2 shift;
  int slice;
  double weight;
};

/// Distance between the grid's slices: that of the scan's denser ones, so that no detail is lost. A
/// few slices that are much closer, such as one scanned twice, do not count.
double DistanceMm(const std::vector<glm::dvec3>& slices)
{
  std::vector<double> gaps;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    gaps.push_back(slices[i].z - slices[i - 1].z);
  }
  std::sort(gaps.begin(), gaps.end());
  return std::max(gaps[(gaps.size() - 1) / 10], 0.25 * gaps[gaps.size() / 2]);
}

EvenGrid GridOf(vtkImageData* image, const std::vector<glm::dvec3>& positionsMm)
{
  // The axes run along rows, columns and the normal.
  const double* const rows = image->GetDirectionMatrix()->GetData();
  const double* const spacingMm = image->GetSpacing();
  glm::dmat3 axes;
  axes[0] = glm::normalize(glm::dvec3(rows[0], rows[3], rows[6]));
  axes[2] = glm::normalize(glm::cross(axes[0], glm::dvec3(rows[1], rows[4], rows[7])));
  axes[1] = glm::cross(axes[2], axes[0]);

  EvenGrid grid;
  glm::dvec3 first(std::numeric_limits<double>::infinity());
  glm::dvec3 last(-first);
  for (const glm::dvec3& positionMm : positionsMm)
  {
    const glm::dvec3 wayMm = (positionMm - positionsMm[0]) * axes;
    grid.slices.push_back({ wayMm.x / spacingMm[0], wayMm.y / spacingMm[1], wayMm.z });
    first = glm::min(first, grid.slices.back());
    last = glm::max(last, grid.slices.back());
  }
  // Rounded to whole voxels, so that slices directly above each other keep their values.
  first = { std::floor(first.x + Tolerance), std::floor(first.y + Tolerance), first.z };
  last = { std::ceil(last.x - Tolerance), std::ceil(last.y - Tolerance), last.z };
  const double gapCount = std::round((last.z - first.z) / DistanceMm(grid.slices));
  const int* const voxels = image->GetDimensions();
  grid.dimensions = { voxels[0] + WholeNumber(last.x - first.x),
    voxels[1] + WholeNumber(last.y - first.y), WholeNumber(gapCount) + 1 };
  grid.geometry.axesMm = { axes[0] * spacingMm[0], axes[1] * spacingMm[1],
    axes[2] * (last.z - first.z) / gapCount };
  grid.geometry.originMm =
    positionsMm[0] + grid.geometry.axesMm[0] * first.x + grid.geometry.axesMm[1] * first.y;
  for (glm::dvec3& slice : grid.slices)
  {
    slice -= first;
  }
  return grid;
}

/// The voxels of a row or column to use: one, or two with the second's fraction.
struct Pair
{
  explicit Pair(double position)
    : first(WholeNumber(std::floor(position + Tolerance)))
    , fraction(std::max(0.0, position - double(this->first)))
  {
    this->fraction = this->fraction < Tolerance ? 0.0 : this->fraction;
  }

  std::int64_t first;
  double fraction;
};

/// Adds the terms that one slice of the scan contributes to a slice of the grid.
void AddTaps(const glm::dvec3& place, int slice, double weight, std::vector<Tap>& taps)
{
  const Pair x(-place.x);
  const Pair y(-place.y);
  for (const glm::i64vec2 step : { glm::i64vec2(0, 0), { 1, 0 }, { 0, 1 }, { 1, 1 } })
  {
    const double part =
      (step.x ? x.fraction : 1.0 - x.fraction) * (step.y ? y.fraction : 1.0 - y.fraction);
    if (weight * part > 0.0)
    {
      taps.push_back({ glm::i64vec2(x.first, y.first) + step, slice, weight * part });
    }
  }
}

/// All terms for a slice of the grid; they are the same for each of its voxels.
std::vector<Tap> TapsAt(const EvenGrid& grid, double heightMm)
{
  const auto isBelow = [](const glm::dvec3& slice, double limitMm) { return slice.z < limitMm; };
  const auto found =
    std::lower_bound(grid.slices.begin() + 1, grid.slices.end() - 1, heightMm, isBelow);
  const int behind = int(found - grid.slices.begin());
  const glm::dvec3& from = grid.slices[behind - 1];
  const glm::dvec3& to = grid.slices[behind];
  double weight = std::clamp((heightMm - from.z) / (to.z - from.z), 0.0, 1.0);
  weight = std::abs(weight - std::round(weight)) < Tolerance ? std::round(weight) : weight;
  std::vector<Tap> taps;
  AddTaps(from, behind - 1, 1.0 - weight, taps);
  AddTaps(to, behind, weight, taps);
  return taps;
}

/// Range of voxels along an axis, end excluded, for which all terms are inside the scan.
std::array<std::int64_t, 2> Inside(const std::vector<Tap>& taps, int axis, int count)
{
  std::array<std::int64_t, 2> range = { 0, std::numeric_limits<std::int64_t>::max() };
  for (const Tap& tap : taps)
  {
    range[0] = std::max(range[0], -tap.shift[axis]);
    range[1] = std::min(range[1], count - tap.shift[axis]);
  }
  range[1] = std::max(range[0], range[1]);
  return range;
}

template <class Type>
Type Rounded(double value)
{
  return Type(std::is_integral<Type>::value ? std::floor(value + 0.5) : value);
}

/// Fills a slice of the grid, which begins at `slice`. Leaves values outside the scan unchanged.
template <class Type>
void Resample(
  vtkImageData* scan, const std::vector<Tap>& taps, std::int64_t columnCount, Type* slice)
{
  const int* const voxels = scan->GetDimensions();
  const std::int64_t valueCount = scan->GetNumberOfScalarComponents();
  const auto* const values = static_cast<const Type*>(scan->GetScalarPointer());
  const std::array<std::int64_t, 2> columns = Inside(taps, 0, voxels[0]);
  const std::array<std::int64_t, 2> rows = Inside(taps, 1, voxels[1]);
  const auto fillRow = [&](std::int64_t row)
  {
    const auto valueAt = [&](std::int64_t i)
    {
      double sum = 0.0;
      for (const Tap& tap : taps)
      {
        const std::int64_t line =
          (std::int64_t(tap.slice) * voxels[1] + row + tap.shift.y) * voxels[0] + tap.shift.x;
        sum += tap.weight * double(values[line * valueCount + i]);
      }
      return sum;
    };
    for (std::int64_t i = columns[0] * valueCount; i < columns[1] * valueCount; ++i)
    {
      slice[row * columnCount * valueCount + i] = Rounded<Type>(valueAt(i));
    }
  };
  tbb::parallel_for(rows[0], rows[1], fillRow);
}

/// Fills the image with the lowest value of each component of the scan.
void FillWithLowest(vtkImageData* scan, vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  for (int component = 0; component < scan->GetNumberOfScalarComponents(); ++component)
  {
    values->FillComponent(component, scan->GetPointData()->GetScalars()->GetRange(component)[0]);
  }
}

}

Volume Rectified(const std::string& path, const Volume& volume, ReadProgress& progress)
{
  vtkImageData* const scan = volume.image;
  const EvenGrid grid = GridOf(scan, volume.irregularSlicesMm);
  const VoxelLayout layout = { grid.dimensions, scan->GetScalarType(),
    scan->GetNumberOfScalarComponents() };
  CheckedByteCount(path, layout);
  Volume rectified = volume;
  rectified.isRectified = true;
  rectified.image = AllocatedImage(layout);
  PlaceImage(path, grid.geometry, rectified.image);
  FillWithLowest(scan, rectified.image);
  const double distanceMm = rectified.image->GetSpacing()[2];
  for (int slice = 0; slice < int(grid.dimensions[2]); ++slice)
  {
    const std::vector<Tap> taps = TapsAt(grid, slice * distanceMm);
    void* const begin = rectified.image->GetScalarPointer(0, 0, slice);
    switch (layout.scalarType)
    {
      vtkTemplateMacro(Resample(scan, taps, grid.dimensions[0], static_cast<VTK_TT*>(begin)));
    }
    progress.Report(double(slice + 1) / double(grid.dimensions[2]));
  }
  rectified.warnings.push_back(
    "The slices were resampled on an even grid; values between scanned slices are interpolated.");
  return rectified;
}

}
