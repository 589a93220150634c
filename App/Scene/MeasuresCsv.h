#ifndef Varimarch_Scene_MeasuresCsv_h
#define Varimarch_Scene_MeasuresCsv_h

#include "Scene/Placing.h"

#include <string>

namespace varimarch
{

/// A header line, then a line per measurement: its number, kind as in scene files, name, numbers
/// with their units, and points in LPS, "x y z; x y z". Statistics are in HU for CT, in SUV where
/// that is known, and otherwise in the units of the data. Numbers that a kind does not have are
/// empty. Numbers are written as in C. Statistics of the volumes over the first one are in lines of
/// their own, with the number of the volume.
std::string CsvOf(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<PlacedVolume>& over = {});

}

#endif
