#include "Scene/MeasureUnits.h"

#include "Scene/VolumeLoading.h"

namespace varimarch
{

std::string UnitOf(const LoadedVolume& volume)
{
  return volume.modality == "CT" ? "HU" : volume.uptakeValueFactor > 0.0 ? "SUV" : "";
}

double FactorToUnit(const LoadedVolume& volume)
{
  return volume.uptakeValueFactor > 0.0 ? volume.uptakeValueFactor : 1.0;
}

RegionStatistics InUnits(RegionStatistics statistics, const LoadedVolume& volume)
{
  const double factor = FactorToUnit(volume);
  statistics.mean *= factor;
  statistics.standardDeviation *= factor;
  statistics.smallest *= factor;
  statistics.largest *= factor;
  return statistics;
}

MeasureValues InUnits(MeasureValues values, const LoadedVolume& volume)
{
  if (values.statistics)
  {
    values.statistics = InUnits(*values.statistics, volume);
  }
  return values;
}

}
