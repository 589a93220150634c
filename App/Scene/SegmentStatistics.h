#ifndef Varimarch_Scene_SegmentStatistics_h
#define Varimarch_Scene_SegmentStatistics_h

#include "Scene/RegionStatistics.h"
#include "Scene/Scene.h"

#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Statistics of a scan in each segment of a label map.
/// @param numbers  as LabelMap::image, on the grid of the scan
/// @param count    number of segments
std::vector<RegionStatistics> StatisticsOfSegments(
  vtkImageData* numbers, std::size_t count, vtkImageData* scan);

/// A header line, then a line per segment: "value,name,voxels,volume_ml,mean,standard_deviation,
/// smallest,largest". Numbers are written as in C; the last four are empty without voxels.
std::string CsvOf(
  const std::vector<Segment>& segments, const std::vector<RegionStatistics>& statistics);

}

#endif
