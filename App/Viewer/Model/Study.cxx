#include "Viewer/Model/Study.h"

#include <utility>

namespace varimarch
{

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

std::vector<vtkSmartPointer<vtkImageData>> OverlayImages(const Study& study)
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  for (const auto& overlay : study.overlays)
  {
    images.push_back(overlay->volume.image);
  }
  return images;
}

}
