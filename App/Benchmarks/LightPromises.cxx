#include "LightPromises.h"

#include "CommandLine/Results.h"
#include "CommandLine/VtkMessages.h"
#include "Scene/OffscreenView.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The scene from another side.
Scene ViewOf(Scene scene, int view, int views)
{
  scene.camera.azimuthDegrees =
    std::remainder(scene.camera.azimuthDegrees + 360.0 * view / views, 360.0);
  return scene;
}

double SmallestOf(const std::vector<double>& tolerances)
{
  return *std::min_element(tolerances.begin(), tolerances.end());
}

std::vector<float> ImageOf(const Scene& scene, vtkImageData* image)
{
  OffscreenView view(scene, image, MapperKind::Varimarch);
  return PixelsOf(view);
}

std::string NameOf(double errorTolerance)
{
  return "1/" + Fixed(1.0 / errorTolerance, 0);
}

/// All views of all scenes at one tolerance.
struct Keeping
{
  int views = 0;
  int kept = 0;         ///< views in which 99.9 % of the pixels keep the tolerance
  int keptTwice = 0;    ///< views in which all pixels keep twice the tolerance
  double worst = 0.0;   ///< largest error of 99.9 % of the pixels, over the tolerance
  double largest = 0.0; ///< largest error, over the tolerance

  void Add(const LightPromise& promise)
  {
    const double part = promise.error.percentile999 / (255.0 * promise.errorTolerance);
    const double largestPart = promise.error.largest / (255.0 * promise.errorTolerance);
    ++this->views;
    this->kept += part <= 1.0 ? 1 : 0;
    this->keptTwice += largestPart <= 2.0 ? 1 : 0;
    this->worst = std::max(this->worst, part);
    this->largest = std::max(this->largest, largestPart);
  }
};

std::string SummaryRow(const std::vector<LightPromises>& scenes, double errorTolerance)
{
  Keeping keeping;
  for (const LightPromises& scene : scenes)
  {
    for (const LightPromise& promise : scene.promises)
    {
      if (promise.errorTolerance == errorTolerance)
      {
        keeping.Add(promise);
      }
    }
  }
  const std::string of = " of " + std::to_string(keeping.views);
  return "| " + NameOf(errorTolerance) + " | " + std::to_string(keeping.kept) + of + " | " +
    Fixed(keeping.worst, 2) + " | " + std::to_string(keeping.keptTwice) + of + " | " +
    Fixed(keeping.largest, 1) + " |\n";
}

double WorstOf(const LightPromises& scene, double errorTolerance)
{
  double worst = 0.0;
  for (const LightPromise& promise : scene.promises)
  {
    worst = promise.errorTolerance == errorTolerance ? std::max(worst, promise.error.percentile999)
                                                     : worst;
  }
  return worst;
}

}

std::vector<LightPromise> MeasureLightPromises(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  Scene lit = WithFeature(LitScene(loaded, options), options.feature);
  lit.size = { std::max(options.side / 2, 1), std::max(options.side / 2, 1) };
  std::vector<LightPromise> promises;
  for (int view = 0; view < options.views; ++view)
  {
    Scene scene = ViewOf(lit, view, options.views);
    onStep("errors, view " + std::to_string(view + 1));
    const std::vector<float> truth =
      ImageOf(FineScene(scene, SmallestOf(options.tolerances)), loaded.volume.image);
    for (const double errorTolerance : options.tolerances)
    {
      scene.render.errorTolerance = errorTolerance;
      const std::vector<float> drawn = ImageOf(scene, loaded.volume.image);
      promises.push_back(
        { view, errorTolerance, CompareImages(drawn.data(), truth.data(), truth.size() / 4) });
    }
  }
  ThrowIfVtkReportedError();
  return promises;
}

std::string MarkdownOf(const std::vector<LightPromises>& scenes, const LightCostOptions& options)
{
  std::string text = "\n## Tolerances\n" + std::to_string(options.views) +
    " views of each scene in the same light, of half the side, against rays with samples " +
    Fixed(FineDistanceVoxels(SmallestOf(options.tolerances)), 3) +
    " of a voxel apart. Kept: 99.9 % of the pixels are within the tolerance, and the largest error "
    "is within twice of it. Errors are parts of the tolerance.\n\n"
    "| tolerance | 99.9 % kept | worst | largest within twice | worst "
    "|\n|---|---:|---:|---:|---:|\n";
  std::string perScene =
    "\nThe error of 99.9 % of the pixels in the worst view [1/255].\n\n| scene |";
  std::string line = "|---|";
  for (const double errorTolerance : options.tolerances)
  {
    text += SummaryRow(scenes, errorTolerance);
    perScene += " " + NameOf(errorTolerance) + ": " + Fixed(255.0 * errorTolerance, 2) + " |";
    line += "---:|";
  }
  perScene += "\n" + line + "\n";
  for (const LightPromises& scene : scenes)
  {
    perScene += "| " + scene.scene + " |";
    for (const double errorTolerance : options.tolerances)
    {
      perScene += " " + Fixed(WorstOf(scene, errorTolerance), 2) + " |";
    }
    perScene += "\n";
  }
  return text + perScene;
}

}
