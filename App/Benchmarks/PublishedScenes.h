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
/// CUDA", 2009. PublishedReport says what is known of them and what we assume.

/// Banquero's numbers of samples along a ray.
constexpr int PublishedSteps[] = { 40, 60, 80, 120 };

/// A volume of Banquero's tables with their frames per second; 0 where a table has none.
struct PublishedVolume
{
  std::string name;   ///< as the paper calls it
  std::string file;   ///< in the folder of volumes
  std::string remark; ///< how ours differs from theirs
  double stepsFps[4]; ///< table 1, at each of PublishedSteps
  double plainFps;    ///< table 2, ray casting
  double fieldFps;    ///< table 2, with the field
};

const std::vector<PublishedVolume>& PublishedVolumes();

/// Our measurements on one of them: the methods "plain", "field" and "ours" at each of
/// PublishedSteps.
struct MeasuredVolume
{
  PublishedVolume published;
  WorkPrecision measured;
};

/// Volt's opacities on VIS MALE: the methods "ours", "off" and "vtk-gpu" at its sample distance.
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
  std::vector<std::string> missing; ///< files that the folder does not hold
};

struct PublishedOptions
{
  std::string folder; ///< of the volumes; missing ones are left out
  int side = 512;     ///< of the square images [pixels]
  int rounds = 3;
};

/// Called after each scene with all measurements so far.
using OnPublished = std::function<void(const PublishedMeasurements&)>;

/// @throws std::runtime_error when the folder holds none, or a mapper reports an error
PublishedMeasurements MeasurePublished(
  const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured);

}

#endif
