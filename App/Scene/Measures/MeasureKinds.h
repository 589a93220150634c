#ifndef Varimarch_Scene_MeasureKinds_h
#define Varimarch_Scene_MeasureKinds_h

#include "Scene/Measures/RegionStatistics.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/Placing.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// The numbers of a measurement. Those that its kind does not have are empty.
struct MeasureValues
{
  std::optional<double> lengthMm = {};
  std::optional<double> degrees = {};
  std::optional<double> areaMm2 = {};
  std::optional<double> volumeMm3 = {};
  /// Voxels of a box, see StatisticsOfBox, or pixels of a region, see StatisticsOfFlatRegion.
  std::optional<RegionStatistics> statistics = {};
};

/// Lines through points in world space [mm].
using MeasureLines = std::vector<std::vector<glm::dvec3>>;

/// The points of a measurement that can be dragged.
enum class MeasureHandles
{
  Each,
  FirstMovesAll, ///< each; the first takes the others with it
  FirstOnly,     ///< the first, which takes the others with it
};

/// A sign that is drawn with the lines.
enum class MeasureSign
{
  None,
  Arc,       ///< at the second point, between the others
  ArrowHead, ///< at the last point
};

/// The properties of a kind of measurement, so that no other place tells kinds apart: files, lists,
/// tables, views and the mouse all read this.
struct MeasureTraits
{
  MeasureKind kind;
  const char* name; ///< in files
  std::size_t fewestPoints;
  std::size_t mostPoints;
  MeasureHandles handles;
  MeasureSign sign;
  bool isFlat;    ///< true: it lies in a slice, so that it is drawn in slices only
  bool hasWords;  ///< true: its name is what it says
  int labelPoint; ///< number of the point that the label lies beside; -1: the middle of all
  MeasureLines (*linesOf)(const Measure&, vtkImageData*); ///< null: no lines
  /// Values in the voxels of the second volume, which may be the first, the one that is measured;
  /// null: no values.
  MeasureValues (*valuesOf)(const Measure&, vtkImageData*, vtkImageData*);
};

/// All kinds, in the order of MeasureKind.
const std::vector<MeasureTraits>& AllMeasureTraits();

const MeasureTraits& TraitsOf(MeasureKind kind);

/// The lines that show a measurement of a volume.
MeasureLines LinesOf(const Measure& measure, vtkImageData* image);

MeasureValues ValuesOf(const Measure& measure, vtkImageData* image);

/// The statistics of a volume over the one that was measured; empty for kinds without statistics.
/// @param over  at its place
std::optional<RegionStatistics> StatisticsOver(
  const Measure& measure, vtkImageData* image, vtkImageData* over);

std::vector<glm::dvec3> PointsOf(const Measure& measure);

/// The middle of the points of a measurement.
glm::dvec3 MiddleOf(const Measure& measure);

/// The number of points that can be dragged, which are the first ones.
std::size_t HandleCount(const Measure& measure);

/// Moves one of these points, and those that it takes with it.
void MovePoint(Measure& measure, int point, const glm::dvec3& stepMm);

struct LoadedVolume;

/// The unit of a volume's values: "HU", "SUV", or empty if it is not known.
std::string UnitOf(const LoadedVolume& volume);

/// The factor from the volume's values to that unit, > 0.
double FactorToUnit(const LoadedVolume& volume);

/// Statistics in that unit: uptake values where they are known.
RegionStatistics InUnits(RegionStatistics statistics, const LoadedVolume& volume);
MeasureValues InUnits(MeasureValues values, const LoadedVolume& volume);

/// A header line, then a line per measurement: its number, kind as in scene files, name, numbers
/// with their units, and points in LPS, "x y z; x y z". Statistics are in HU for CT, in SUV where
/// that is known, and otherwise in the units of the data. Numbers that a kind does not have are
/// empty. Numbers are written as in C. Statistics of the volumes over the first one are in lines of
/// their own, with the number of the volume.
std::string CsvOf(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<PlacedVolume>& over = {});

}

#endif
