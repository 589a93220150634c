#include "Scene/LabelMap.h"

#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkTransform.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

[[noreturn]] void FailToDraw(const std::string& path, const std::string& reason)
{
  throw std::runtime_error("Cannot draw the labels of " + path + " over the scan: " + reason + ".");
}

vtkSmartPointer<vtkTransform> LabelIndexFromScanIndex(vtkImageData* labels, vtkImageData* scan)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->SetMatrix(labels->GetPhysicalToIndexMatrix());
  transform->Concatenate(scan->GetIndexToPhysicalMatrix());
  return transform;
}

// vtkImageReslice ignores the directions of images, so it gets grids of indices.
vtkSmartPointer<vtkImageData> OnGridOf(vtkImageData* scan, vtkImageData* numbers)
{
  vtkNew<vtkImageData> indices;
  indices->ShallowCopy(numbers);
  indices->SetOrigin(0.0, 0.0, 0.0);
  indices->SetSpacing(1.0, 1.0, 1.0);
  indices->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(indices);
  reslice->SetResliceTransform(LabelIndexFromScanIndex(numbers, scan));
  reslice->SetInterpolationModeToNearestNeighbor();
  reslice->SetOutputExtent(scan->GetExtent());
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->Update();
  vtkSmartPointer<vtkImageData> resliced = reslice->GetOutput();
  resliced->SetOrigin(scan->GetOrigin());
  resliced->SetSpacing(scan->GetSpacing());
  resliced->SetDirectionMatrix(scan->GetDirectionMatrix());
  return resliced;
}

std::string BoxText(vtkImageData* image)
{
  const double* const bounds = image->GetBounds();
  std::ostringstream text;
  text.precision(4);
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis > 0 ? ", " : "") << "xyz"[axis] << ' ' << bounds[2 * axis] << " to "
         << bounds[2 * axis + 1];
  }
  return text.str() + " mm";
}

double VolumeMl(const std::vector<SegmentSize>& sizes)
{
  double sum = 0.0;
  for (const SegmentSize& size : sizes)
  {
    sum += size.volumeMl;
  }
  return sum;
}

// A list such as "liver, spleen and 3 others".
std::string NameList(const std::vector<std::string>& names)
{
  constexpr std::size_t MostNamed = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), MostNamed); ++i)
  {
    list += (i > 0 ? ", " : "") + names[i];
  }
  return names.size() > MostNamed
    ? list + " and " + std::to_string(names.size() - MostNamed) + " more"
    : list;
}

void CheckFrameOfReference(
  const LoadedVolume& labels, const std::string& path, const LoadedVolume& scan)
{
  const std::string& ofLabels = labels.frameOfReference;
  const std::string& ofScan = scan.frameOfReference;
  if (!ofLabels.empty() && !ofScan.empty() && ofLabels != ofScan)
  {
    FailToDraw(path,
      "expected the scan's frame of reference " + ofScan + ", found " + ofLabels +
        "; choose the scan that the labels were drawn on");
  }
}

// Compares the sizes before and after, which differ little unless something was lost.
void WarnOfLosses(const std::vector<SegmentSize>& before, LabelMap& map)
{
  constexpr double SmallestLoss = 0.02;
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < map.segments.size(); ++i)
  {
    if (before[i].voxels > 0 && map.sizes[i].voxels == 0)
    {
      lost.push_back(map.segments[i].name);
    }
  }
  if (!lost.empty())
  {
    map.warnings.push_back("Segments have no voxel of the scan, because they are smaller or lie "
                           "outside: " +
      NameList(lost) + ".");
  }
  const double part = VolumeMl(map.sizes) / VolumeMl(before);
  if (part < 1.0 - SmallestLoss)
  {
    map.warnings.push_back("Only " + std::to_string(std::lround(100.0 * part)) +
      " % of the labels' volume lies inside the scan and is drawn.");
  }
}

std::vector<Segment> SegmentsOfFile(
  const LoadedVolume& labels, const std::string& path, std::vector<std::string>& warnings)
{
  try
  {
    return labels.segments.empty() ? SegmentsOf(labels.image, {}, warnings) : labels.segments;
  }
  catch (const std::invalid_argument& reason)
  {
    FailToDraw(path, reason.what());
  }
}

}

bool AreOnGridOf(vtkImageData* labels, vtkImageData* scan)
{
  constexpr double MostVoxels = 0.1; // that corners may differ by, since files round places
  int size[3];
  int scanSize[3];
  labels->GetDimensions(size);
  scan->GetDimensions(scanSize);
  bool areOn = std::equal(size, size + 3, scanSize);
  const auto transform = LabelIndexFromScanIndex(labels, scan);
  for (int corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = (corner >> axis & 1) * size[axis];
    }
    glm::dvec3 labelIndex;
    transform->TransformPoint(&index.x, &labelIndex.x);
    areOn = areOn && glm::distance(index, labelIndex) < MostVoxels;
  }
  return areOn;
}

LabelMap LabelMapOf(const LoadedVolume& labels, const std::string& path, const LoadedVolume& scan)
{
  CheckFrameOfReference(labels, path, scan);
  LabelMap map;
  map.warnings = labels.warnings;
  if (scan.slices == SliceLayout::Irregular)
  {
    map.warnings.emplace_back(
      "The slices of the scan are tilted or uneven; where they are not drawn "
      "where they were scanned, the labels lie beside them.");
  }
  map.segments = SegmentsOfFile(labels, path, map.warnings);
  const auto numbers = SegmentNumbers(labels.image, map.segments);
  const std::vector<SegmentSize> before = SizesOf(numbers, map.segments.size());
  map.image = OnGridOf(scan.image, numbers);
  map.sizes = SizesOf(map.image, map.segments.size());
  if (VolumeMl(before) == 0.0)
  {
    map.warnings.push_back("No voxel of " + path + " has a label.");
  }
  else if (VolumeMl(map.sizes) == 0.0)
  {
    FailToDraw(path,
      "expected labels within the scan, at " + BoxText(scan.image) + ", found labels within " +
        BoxText(labels.image) + "; choose the scan that the labels were drawn on");
  }
  else
  {
    WarnOfLosses(before, map);
  }
  return map;
}

LabelMap LoadLabels(
  const SceneLabels& labels, const LoadedVolume& scan, const LoadObserver& observer)
{
  LabelMap map = LabelMapOf(LoadLabelVolume(labels, observer), labels.path, scan);
  TakeAppearance(labels.segments, labels.path, map);
  return map;
}

void TakeAppearance(const std::vector<Segment>& ofScene, const std::string& path, LabelMap& map)
{
  for (const Segment& segment : ofScene)
  {
    const auto known = std::find_if(map.segments.begin(), map.segments.end(),
      [&](const Segment& own) { return own.value == segment.value; });
    if (known == map.segments.end())
    {
      map.warnings.push_back("The scene has a segment of the value " +
        std::to_string(segment.value) + ", which " + path + " does not have.");
      continue;
    }
    *known = segment;
  }
}

Look LookOfLabelsOnly()
{
  Look look;
  look.name = "labels";
  look.colors = { { 0.0, glm::dvec3(1.0) } };
  look.opacities = { { 0.0, 0.0 } };
  return look;
}

}
