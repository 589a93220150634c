#include "Scene/SegmentStatistics.h"

#include "Scene/CsvText.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <sstream>

namespace varimarch
{

namespace
{

constexpr double Mm3PerMl = 1000.0;

}

std::vector<RegionStatistics> StatisticsOfSegments(
  vtkImageData* numbers, std::size_t count, vtkImageData* scan)
{
  const auto* const segments = static_cast<const unsigned char*>(numbers->GetScalarPointer());
  vtkDataArray* const scalars = scan->GetPointData()->GetScalars();
  double range[2];
  scalars->GetFiniteRange(range, 0);
  // The first element counts the voxels in no segment.
  const std::vector<ValueSums> none(count + 1, ValueSums(0.5 * range[0] + 0.5 * range[1]));
  tbb::combinable<std::vector<ValueSums>> sumsOfThreads([&] { return none; });
  const auto sumUp = [&](auto* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, tuples.size(), 65536),
      [&](const tbb::blocked_range<vtkIdType>& voxels)
      {
        std::vector<ValueSums>& sums = sumsOfThreads.local();
        for (vtkIdType i = voxels.begin(); i != voxels.end(); ++i)
        {
          sums[segments[i]].Add(double(tuples[i][0]));
        }
      });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, sumUp))
  {
    sumUp(scalars);
  }
  std::vector<ValueSums> all = none;
  sumsOfThreads.combine_each(
    [&](const std::vector<ValueSums>& sums)
    {
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        all[i].Join(sums[i]);
      }
    });
  std::vector<RegionStatistics> statistics;
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    statistics.push_back(all[i].Statistics(scan));
  }
  return statistics;
}

std::string CsvOf(
  const std::vector<Segment>& segments, const std::vector<RegionStatistics>& statistics)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "value,name,voxels,volume_ml,mean,standard_deviation,smallest,largest\n";
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const RegionStatistics& region = statistics[i];
    text << segments[i].value << ',' << QuotedForCsv(segments[i].name) << ',' << region.voxels
         << ',' << region.volumeMm3 / Mm3PerMl;
    if (region.voxels > 0)
    {
      text << ',' << region.mean << ',' << region.standardDeviation << ',' << region.smallest << ','
           << region.largest << '\n';
    }
    else
    {
      text << ",,,,\n";
    }
  }
  return text.str();
}

}
