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

std::shared_ptr<const Study> WithoutLabels(const Study& scan)
{
  Study bare = scan;
  bare.segmentStatistics.clear();
  bare.labels.reset();
  return std::make_shared<const Study>(std::move(bare));
}

}
