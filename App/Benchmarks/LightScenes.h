#ifndef Varimarch_Benchmarks_LightScenes_h
#define Varimarch_Benchmarks_LightScenes_h

#include "BenchScenes.h"

#include <vector>

namespace varimarch
{

class OffscreenView;

// The scenes of measurements of light, and their true images.

/// A kind of light whose cost is measured. Each has a benchmark of its name.
struct LightFeature
{
  const char* name;
  const char* text;    ///< the feature in words
  const char* dragged; ///< the setting that is dragged
  void (*add)(Scene&); ///< adds it to a scene with one light
};

const std::vector<LightFeature>& LightFeatures();

struct LightCostOptions
{
  BenchSceneOptions scenes;
  LightFeature feature = LightFeatures().front(); ///< shadows
  int side = 512;                                 ///< side of the square images [pixels]
  int rounds = 3;
  double errorTolerance = 1.0 / 64.0; ///< tolerance of the measurements of time
  /// Tolerances whose errors are measured, and the number of views in which they are.
  std::vector<double> tolerances = { 1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0 };
  int views = 4;
};

/// Adds the options that all benchmarks of light have.
void AddLightOptions(CLI::App& command, LightCostOptions& options);

/// Adds to the results how they are measured.
void AddLightConditions(const LightCostOptions& options, BenchResults& results);

/// The scene shaded, in one light from the upper right of its camera, which is fixed in the world
/// and has no feature yet.
Scene LitScene(const LoadedScene& loaded, const LightCostOptions& options);

Scene WithFeature(Scene scene, const LightFeature& feature);

/// The distance between samples of images that judge others [voxels]. At an eighth, shadows of
/// dense material are wrong by 2 of 255 for 99.9 % of the pixels, and by far more for single ones.
double FineDistanceVoxels(double errorTolerance);

/// The same with samples at that distance and without a lattice of light. Its image judges others.
Scene FineScene(Scene scene, double errorTolerance);

/// The light, turned about the patient.
SceneLight Turned(SceneLight light, double degrees);

/// A new frame: premultiplied RGBA of all pixels.
std::vector<float> PixelsOf(OffscreenView& view);

}

#endif
