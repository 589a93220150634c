#ifndef Varimarch_Scene_MeasuresCsv_h
#define Varimarch_Scene_MeasuresCsv_h

#include "Scene/Scene.h"

#include <string>

namespace varimarch
{

struct LoadedVolume;

/// A header line, then a line per measurement: its number, kind as in scene files, name, numbers
/// with their units, and points in LPS, "x y z; x y z". Statistics are in HU for CT, in SUV where
/// that is known, and otherwise in the units of the data. Numbers that a kind does not have are
/// empty. Numbers are written as in C.
std::string CsvOf(const std::vector<Measure>& measures, const LoadedVolume& volume);

}

#endif
