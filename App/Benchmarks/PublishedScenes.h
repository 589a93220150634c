#ifndef Varimarch_Benchmarks_PublishedScenes_h
#define Varimarch_Benchmarks_PublishedScenes_h

#include "PublishedPromise.h"
#include "PublishedVolumes.h"
#include "WorkPrecision.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The scenes on which two papers measured: M. Banquero, E. Ortiz, B. Rossi, "Realtime volume
/// render en videojuegos", 2016, tables 1 and 2, and "Volt: interactive volume rendering with
/// CUDA", 2009. PublishedReport states what is known of them and what we assume.

/// E in 1/255 of the values' range: that of figure 10 without artefacts.
constexpr double PublishedVariation255 = 4.0;

/// The steps of whole rays [smallest voxel spacings].
constexpr double PublishedStepVoxels[] = { 1.0, 0.5 };

/// Our measurements on one data set. The method "steps" has one point for each row of table 1, and
/// "rc" and "df" have one for each of PublishedStepVoxels; "tolerance" and "tolerance-shader" are
/// swept over error tolerances.
struct MeasuredDataSet
{
  PublishedDataSet published;
  WorkPrecision measured;
  std::optional<PublishedPromise> promise; ///< for data sets of table 2
};

/// Gradient below which Volt's light is damped here [units of the data, which are bytes, per
/// voxel].
constexpr double VoltDampingPerVoxel = 10.0;

/// Our measurements on VIS MALE with one of Volt's opacities: the methods "ours", "off" and, where
/// no light is damped, "vtk-gpu" at Volt's sample distance.
struct MeasuredVolt
{
  int alpha255;
  bool shaded;
  WorkPrecision measured;
};

struct PublishedMeasurements
{
  std::vector<MeasuredDataSet> dataSets;
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

/// A grey ramp, clear below a threshold, and soft enough that rays reach deep into the volume.
Look SoftLook(vtkImageData* image);

/// The paper's loop: plain ray casting, or with the field of variations for E [1/255].
RenderOptions PublishedLoop(vtkImageData* image, bool hasField, double variation255);

/// Measures the scenes of both papers.
/// @throws std::runtime_error when the folder holds no volume, or a mapper reports an error
PublishedMeasurements MeasurePublished(
  const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured);

}

#endif
