#include "Viewer/Model/Study.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

std::string SizeText(const VolumeSize& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]) + " voxels of " + std::to_string(size[3]) + " components";
}

}

VolumeSize SizeOfVolume(const LoadedVolume& volume)
{
  const int* const sides = volume.image->GetDimensions();
  return { sides[0], sides[1], sides[2], volume.image->GetNumberOfScalarComponents() };
}

void CheckSizeOfTime(const LoadedVolume& ofTime, const VolumeSize& expected)
{
  const VolumeSize found = SizeOfVolume(ofTime);
  if (found != expected)
  {
    throw std::runtime_error("Cannot show the time of number " +
      std::to_string(ofTime.times.current) + ", counted from 0: expected " + SizeText(expected) +
      " as at the other times, found " + SizeText(found));
  }
}

std::shared_ptr<const Study> WithLabels(const Study& scan, LabelMap labels)
{
  Study labelled = scan;
  labelled.segmentStatistics =
    StatisticsOfSegments(labels.image, labels.segments.size(), scan.volume.image);
  labelled.labels = std::make_shared<const LabelMap>(std::move(labels));
  return std::make_shared<const Study>(std::move(labelled));
}

std::shared_ptr<const Study> AtTime(const Study& scan, const LoadedVolume& ofTime)
{
  Study other = scan;
  other.volume = ofTime;
  if (other.labels)
  {
    other.segmentStatistics =
      StatisticsOfSegments(other.labels->image, other.labels->segments.size(), other.volume.image);
  }
  return std::make_shared<const Study>(std::move(other));
}

std::shared_ptr<const Study> WithoutLabels(const Study& scan)
{
  Study bare = scan;
  bare.segmentStatistics.clear();
  bare.labels.reset();
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
