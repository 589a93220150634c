#ifndef Varimarch_Scene_MeasureUnits_h
#define Varimarch_Scene_MeasureUnits_h

#include "Scene/MeasureKinds.h"

#include <string>

namespace varimarch
{

struct LoadedVolume;

/// The unit of a volume's values: "HU", "SUV", or empty if it is not known.
std::string UnitOf(const LoadedVolume& volume);

/// The factor from the volume's values to that unit, > 0.
double FactorToUnit(const LoadedVolume& volume);

/// Statistics in that unit: uptake values where they are known.
RegionStatistics InUnits(RegionStatistics statistics, const LoadedVolume& volume);
MeasureValues InUnits(MeasureValues values, const LoadedVolume& volume);

}

#endif
