#include "Viewer/Model/Study.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

std::shared_ptr<const Study> WithLabels(const Study& scan, LabelMap labels)
{
  Study labelled = scan;
  labelled.segmentStatistics =
    StatisticsOfSegments(labels.image, labels.segments.size(), scan.volume.image);
  labelled.labels = std::make_shared<const LabelMap>(std::move(labels));
  labelled.areSegmentsCounted = true;
  return std::make_shared<const Study>(std::move(labelled));
}

std::shared_ptr<const Study> WithLabelsOnOne(std::vector<std::shared_ptr<const Study>> scans,
  const LoadedVolume& labels, const std::string& path)
{
  std::stable_partition(scans.begin(), scans.end(),
    [&](const auto& scan) { return AreOnGridOf(labels.image, scan->volume.image); });
  for (auto scan = scans.begin();; ++scan)
  {
    try
    {
      return WithLabels(**scan, LabelMapOf(labels, path, (*scan)->volume));
    }
    catch (const std::runtime_error&)
    {
      if (scan + 1 == scans.end())
      {
        throw;
      }
    }
  }
}

std::shared_ptr<const Study> AtTime(const Study& scan, const LoadedVolume& ofTime)
{
  Study other = scan;
  other.volume = ofTime;
  other.areSegmentsCounted = !other.labels;
  return std::make_shared<const Study>(std::move(other));
}

bool FollowsTimes(const Study& first, const Study& over)
{
  const LoadedTimes& times = first.volume.times;
  return times.AreSeveral() && over.volume.times.values.size() == times.values.size();
}

std::shared_ptr<const Study> WithCounts(const Study& study, vtkImageData* image)
{
  const vtkSmartPointer<vtkImageData> numbers = CopyOfLabels(study);
  Study counted = study;
  LabelMap labels = *study.labels;
  labels.sizes = SizesOf(numbers, labels.segments.size());
  counted.segmentStatistics = StatisticsOfSegments(numbers, labels.segments.size(), image);
  counted.labels = std::make_shared<const LabelMap>(std::move(labels));
  counted.areSegmentsCounted = true;
  return std::make_shared<const Study>(std::move(counted));
}

vtkSmartPointer<vtkImageData> SharedCopy(const LoadedVolume& volume)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->ShallowCopy(volume.image);
  if (!volume.isOnDisk)
  {
    vtkDataArray* const scalars = volume.image->GetPointData()->GetScalars();
    const auto own = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    own->ShallowCopy(scalars);
    copy->GetPointData()->SetScalars(own);
  }
  return copy;
}

void WriteLabels(
  const LabelChange& change, bool isForward, vtkImageData* numbers, LabelGuard& guard)
{
  const std::lock_guard<std::mutex> lock(guard.mutex);
  Apply(change, isForward, numbers);
  ++guard.writes;
}

int WritesOfLabels(const Study& study)
{
  const std::lock_guard<std::mutex> lock(study.labelGuard->mutex);
  return study.labelGuard->writes;
}

vtkSmartPointer<vtkImageData> CopyOfLabels(const Study& study)
{
  vtkImageData* const image = study.labels->image;
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->CopyStructure(image);
  copy->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const auto numbersOf = [](vtkImageData* of)
  { return static_cast<unsigned char*>(of->GetScalarPointer()); };
  const std::size_t count = study.labels->segments.size();
  const std::lock_guard<std::mutex> lock(study.labelGuard->mutex);
  std::transform(numbersOf(image), numbersOf(image) + image->GetNumberOfPoints(), numbersOf(copy),
    [count](unsigned char number) { return number > count ? std::uint8_t(0) : number; });
  return copy;
}

std::shared_ptr<const Study> WithoutLabels(const Study& scan)
{
  Study bare = scan;
  bare.segmentStatistics.clear();
  bare.labels.reset();
  bare.areSegmentsCounted = true;
  return std::make_shared<const Study>(std::move(bare));
}

std::shared_ptr<const Study> WithOverlaysOf(
  const Study& scan, const std::shared_ptr<const Study>& form)
{
  if (form->overlays == scan.overlays)
  {
    return form;
  }
  Study withOverlays = *form;
  withOverlays.overlays = scan.overlays;
  return std::make_shared<const Study>(std::move(withOverlays));
}

std::vector<OverlayVoxels> VoxelsOfOverlays(const Study& study)
{
  std::vector<OverlayVoxels> voxels;
  for (const auto& overlay : study.overlays)
  {
    voxels.push_back({ overlay->volume.image, overlay->labels });
  }
  return voxels;
}

const Study& StudyOfVolume(const Study& first, int volume)
{
  return volume == 0 ? first : *first.overlays[volume - 1];
}

std::shared_ptr<const Study> WithVolume(
  const Study& first, int volume, std::shared_ptr<const Study> changed)
{
  if (volume == 0)
  {
    return WithOverlaysOf(first, changed);
  }
  Study study = first;
  study.overlays[volume - 1] = std::move(changed);
  return std::make_shared<const Study>(std::move(study));
}

}
