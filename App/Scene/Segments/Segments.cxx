#include "Scene/Segments/Segments.h"

#include "Scene/Files/SmallFile.h"
#include "Scene/Looks/LookFormats/LookFormats.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

template <class Value>
int LabelOf(Value value)
{
  const auto number = double(value);
  if (!(number >= SmallestLabel && number <= LargestLabel && number == std::floor(number)))
  {
    std::ostringstream found;
    found << number;
    throw std::invalid_argument("expected whole numbers as labels, found " + found.str());
  }
  return int(number);
}

/// The voxels of each label.
using LabelCounts = std::map<int, std::int64_t>;

// Neighbours mostly have the same value, so that few voxels need more than a comparison.
template <class Value>
LabelCounts LabelsIn(const Value* values, vtkIdType count)
{
  LabelCounts labels;
  for (vtkIdType begin = 0; begin < count && labels.size() <= MostLabels + 1;)
  {
    vtkIdType end = begin + 1;
    while (end < count && values[end] == values[begin])
    {
      ++end;
    }
    labels[LabelOf(values[begin])] += end - begin;
    begin = end;
  }
  labels.erase(0);
  return labels;
}

LabelCounts LabelsIn(vtkImageData* image)
{
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(return LabelsIn(
      static_cast<const VTK_TT*>(image->GetScalarPointer()), image->GetNumberOfPoints()));
  }
  return {};
}

template <class Value>
void NumberVoxels(const Value* values, const std::map<int, unsigned char>& numbers,
  unsigned char others, vtkImageData* image)
{
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  Value last = Value(0);
  unsigned char number = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (values[i] != last)
    {
      last = values[i];
      const auto own = last != Value(0) ? numbers.find(int(last)) : numbers.end();
      number = last == Value(0) ? 0 : own == numbers.end() ? others : own->second;
    }
    voxels[i] = number;
  }
}

// Voxels of a segment, and uninterrupted runs of them along each axis.
struct SegmentCounts
{
  std::int64_t voxels = 0;
  std::array<std::int64_t, 3> runs = {};
};

using AllCounts = std::vector<SegmentCounts>;

void CountSlice(vtkImageData* numbers, int slice, AllCounts& counts)
{
  const int* const size = numbers->GetDimensions();
  const vtkIdType steps[3] = { 1, size[0], vtkIdType(size[0]) * size[1] };
  const auto* voxel =
    static_cast<const unsigned char*>(numbers->GetScalarPointer()) + slice * steps[2];
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x, ++voxel)
    {
      if (*voxel == 0)
      {
        continue;
      }
      SegmentCounts& own = counts[*voxel - 1];
      ++own.voxels;
      const int index[3] = { x, y, slice };
      for (int axis = 0; axis < 3; ++axis)
      {
        own.runs[axis] += index[axis] == 0 || voxel[-steps[axis]] != *voxel ? 1 : 0;
      }
    }
  }
}

AllCounts CountsOf(vtkImageData* numbers, std::size_t count)
{
  AllCounts all(count);
  std::mutex mutex;
  tbb::parallel_for(0, numbers->GetDimensions()[2],
    [&](int slice)
    {
      AllCounts here(count);
      CountSlice(numbers, slice, here);
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t i = 0; i < count; ++i)
      {
        all[i].voxels += here[i].voxels;
        for (int axis = 0; axis < 3; ++axis)
        {
          all[i].runs[axis] += here[i].runs[axis];
        }
      }
    });
  return all;
}

// Joins the smallest segments into the last.
std::vector<Segment> WithSharedLast(const std::vector<Segment>& segments, const LabelCounts& counts,
  std::vector<std::string>& warnings)
{
  const auto sizeOf = [&](const Segment& segment)
  {
    const auto count = counts.find(segment.value);
    return count == counts.end() ? 0 : count->second;
  };
  std::vector<std::int64_t> sizes;
  std::transform(segments.begin(), segments.end(), std::back_inserter(sizes), sizeOf);
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  const std::int64_t smallest = sizes[MostSegments - 2];
  std::int64_t ofSmallest = MostSegments - 1 -
    std::count_if(sizes.begin(), sizes.end(), [&](std::int64_t size) { return size > smallest; });
  std::vector<Segment> kept;
  std::optional<int> firstShared;
  for (const Segment& segment : segments)
  {
    const std::int64_t size = sizeOf(segment);
    if (size > smallest || (size == smallest && ofSmallest-- > 0))
    {
      kept.push_back(segment);
    }
    else if (size > 0)
    {
      firstShared = firstShared.value_or(segment.value);
    }
  }
  if (firstShared)
  {
    const std::string count = std::to_string(segments.size() - kept.size());
    kept.push_back({ *firstShared, count + " small segments", glm::dvec3(0.6) });
    warnings.push_back("Of " + std::to_string(segments.size()) + " segments the " + count +
      " smallest share one colour, since at most " + std::to_string(MostSegments) +
      " can be told apart.");
  }
  return kept;
}

}

glm::dvec3 ColorOfLabel(int value)
{
  // The colours of M. Okabe and K. Ito without black, which all kinds of colour vision tell apart
  // (B. Wong, Nature Methods 8, 2011, 441). Orange is first.
  static const std::array<glm::ivec3, 7> safe = { { { 230, 159, 0 }, { 86, 180, 233 },
    { 0, 158, 115 }, { 240, 228, 66 }, { 0, 114, 178 }, { 213, 94, 0 }, { 204, 121, 167 } } };
  if (value >= 1 && value <= int(safe.size()))
  {
    return glm::dvec3(safe[std::size_t(value) - 1]) / 255.0;
  }
  // Multiples of the golden ratio are spread evenly over the circle of hues, however many there
  // are.
  constexpr double GoldenRatio = 0.61803398874989485;
  const double turns = GoldenRatio * value;
  glm::dvec3 rgb;
  vtkMath::HSVToRGB(turns - std::floor(turns), 0.65, 0.95, &rgb.r, &rgb.g, &rgb.b);
  return rgb;
}

std::string NameOfLabel(int value)
{
  return "Label " + std::to_string(value);
}

std::vector<Segment> SegmentsOf(
  vtkImageData* labels, const std::vector<Segment>& known, std::vector<std::string>& warnings)
{
  if (labels->GetNumberOfScalarComponents() != 1)
  {
    throw std::invalid_argument("expected one label per voxel, found " +
      std::to_string(labels->GetNumberOfScalarComponents()) + " values");
  }
  const LabelCounts counts = LabelsIn(labels);
  if (counts.size() > MostLabels)
  {
    throw std::invalid_argument(
      "expected at most " + std::to_string(MostLabels) + " different labels, found more");
  }
  std::vector<Segment> segments = known;
  for (const auto& [value, count] : counts)
  {
    const bool isKnown = std::any_of(known.begin(), known.end(),
      [label = value](const Segment& segment) { return segment.value == label; });
    if (!isKnown)
    {
      segments.push_back({ value, NameOfLabel(value), ColorOfLabel(value) });
    }
  }
  return segments.size() > MostSegments ? WithSharedLast(segments, counts, warnings) : segments;
}

vtkSmartPointer<vtkImageData> SegmentNumbers(
  vtkImageData* labels, const std::vector<Segment>& segments)
{
  std::map<int, unsigned char> numbers;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    numbers[segments[i].value] = static_cast<unsigned char>(i + 1);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(labels);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  switch (labels->GetScalarType())
  {
    vtkTemplateMacro(NumberVoxels(static_cast<const VTK_TT*>(labels->GetScalarPointer()), numbers,
      static_cast<unsigned char>(segments.size()), image));
  }
  return image;
}

// Cauchy's formula: the mean length is the volume by the mean area of the shadow, here that of the
// shadows along the three axes, in which each run of voxels covers one face of a voxel.
std::vector<SegmentSize> SizesOf(vtkImageData* numbers, std::size_t count)
{
  const double* const spacing = numbers->GetSpacing();
  const double voxelMm3 = std::abs(numbers->GetIndexToPhysicalMatrix()->Determinant());
  std::vector<SegmentSize> sizes;
  for (const SegmentCounts& counts : CountsOf(numbers, count))
  {
    double runsPerMm = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      runsPerMm += double(counts.runs[axis]) / (3.0 * spacing[axis]);
    }
    const auto voxels = double(counts.voxels);
    sizes.push_back(
      { counts.voxels, 1e-3 * voxelMm3 * voxels, voxels > 0.0 ? voxels / runsPerMm : 0.0 });
  }
  return sizes;
}

std::vector<Segment> ReadSegmentTable(const std::string& path)
{
  return SegmentsFromTable(BytesOfSmallFile(path), path);
}

void TakeTable(const std::vector<Segment>& table, std::vector<Segment>& segments)
{
  for (Segment& segment : segments)
  {
    const auto row = std::find_if(table.begin(), table.end(),
      [&](const Segment& candidate) { return candidate.value == segment.value; });
    segment = row != table.end() ? *row : segment;
  }
}

}
