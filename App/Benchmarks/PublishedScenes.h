#ifndef Varimarch_Benchmarks_PublishedScenes_h
#define Varimarch_Benchmarks_PublishedScenes_h

#include "WorkPrecision.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// The scenes on which two papers measured: M. Banquero, E. Ortiz, B. Rossi, "Realtime volumen
/// render en videojuegos", 2016, tables 1 and 2, and "Volt: interactive volume rendering with
/// CUDA", 2009. PublishedReport states what is known of them and what we assume.

/// The numbers of samples along a ray in Banquero's tables.
constexpr int PublishedSteps[] = { 40, 60, 80, 120 };

/// A volume of Banquero's tables with their frames per second; 0 where a table has none.
struct PublishedVolume
{
  std::string name;   ///< name in the paper
  std::string file;   ///< path in the folder of volumes
  std::string remark; ///< difference between our volume and theirs
  double stepsFps[4]; ///< frame rates of table 1, at each of PublishedSteps
  double plainFps;    ///< frame rate of table 2, by ray casting
  double fieldFps;    ///< frame rate of table 2, with the field
};

const std::vector<PublishedVolume>& PublishedVolumes();

/// Our measurements on one of these volumes: the methods "plain", "field" and "ours" at each of
/// PublishedSteps.
struct MeasuredVolume
{
  PublishedVolume published;
  WorkPrecision measured;
};

/// Our measurements on VIS MALE with one of Volt's opacities: the methods "ours", "off" and
/// "vtk-gpu" at Volt's sample distance.
struct MeasuredVolt
{
  int alpha255;
  bool shaded;
  WorkPrecision measured;
};

struct PublishedMeasurements
{
  std::vector<MeasuredVolume> volumes;
  std::vector<MeasuredVolt> volt;
  std::vector<std::string> missing; ///< files that are not in the folder
};

struct PublishedOptions
{
  std::string folder; ///< folder of the volumes; missing ones are skipped
  int side = 512;     ///< side of the square images [pixels]
  int rounds = 3;
};

/// Called after each scene with all measurements so far.
using OnPublished = std::function<void(const PublishedMeasurements&)>;

/// Measures the scenes of both papers.
/// @throws std::runtime_error when the folder holds no volume, or a mapper reports an error
PublishedMeasurements MeasurePublished(
  const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured);

}

#endif
