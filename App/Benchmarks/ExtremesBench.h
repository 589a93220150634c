#ifndef Varimarch_Benchmarks_ExtremesBench_h
#define Varimarch_Benchmarks_ExtremesBench_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "Scene/Scene.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// Height and width of the images [pixels]: those of the tests of the same scenes.
constexpr int ExtremesSide = 48;

/// A mapper's image of an extreme scene.
struct ExtremeResult
{
  MapperKind kind;
  bool wasTried;       ///< false for VTK's mappers where they would march for hours
  ImageError error;    ///< [1/255]
  bool isFinite;       ///< true if all channels are finite
  bool isEmpty;        ///< true if nothing is drawn although there is something to see
  std::string message; ///< first error or warning of VTK or of the mapper; empty: none
  double medianMs;     ///< median time of three frames after the first
};

struct ExtremeMeasurement
{
  std::string group; ///< kind of extreme
  std::string name;
  std::vector<ExtremeResult> results; ///< one for each of ExtremeMappers()
};

/// Our mapper by packets and by shaders, and VTK's GPU and fixed-point mappers.
const std::vector<MapperKind>& ExtremeMappers();

/// Draws every scene of ExtremeScenes.h with every mapper at its defaults, and compares each image
/// with the reference integrator's.
/// @param only      beginnings of the names of scenes; empty: all
/// @param onResult  receives all measurements so far after each scene
void MeasureExtremes(const std::vector<std::string>& only, const OnStep& onStep,
  const std::function<void(const std::vector<ExtremeMeasurement>&)>& onResult);

}

#endif
