#include "Truth.h"

#include "Scene/Reference/ReferenceCache.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace varimarch
{

namespace
{

// Draws a picture, and measures its time.
template <class Draw>
Truth TimedTruth(const std::string& activity, const OnStep& onStep, Draw draw)
{
  const auto start = std::chrono::steady_clock::now();
  const ProgressFunction onProgress = [&](double done)
  {
    onStep(activity + ", " + std::to_string(std::lround(100.0 * done)) + " %");
    return true;
  };
  const ReferencePicture reference = draw(onProgress).value();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return { reference.image, reference.largestError, elapsed.count(), {} };
}

}

Truth TruthOf(const Scene& scene, vtkImageData* image, const OnStep& onStep)
{
  // A thousandth of the rounding of an 8-bit display, far below the errors that are compared.
  constexpr double Tolerance = 1e-6;
  return TimedTruth("Integrating the reference", onStep,
    [&](const ProgressFunction& onProgress)
    { return ReferenceCache().Picture(scene, image, Tolerance, onProgress); });
}

Truth TruthByPaths(
  const Scene& scene, vtkImageData* image, const PathSettings& paths, const OnStep& onStep)
{
  Truth truth = TimedTruth("Tracing paths", onStep,
    [&](const ProgressFunction& onProgress)
    { return DrawPathPicture(scene, image, paths, onProgress); });
  truth.paths = paths;
  return truth;
}

std::string Described(const Truth& truth)
{
  std::ostringstream text;
  text.precision(1);
  text << std::scientific;
  if (truth.paths.paths > 0)
  {
    text << truth.paths.paths << " random paths of scattered light for each pixel (largest "
         << "standard error " << 255.0 * truth.largestError << ")";
    return text.str();
  }
  text << "an adaptive integral of each ray in double precision (largest error estimate "
       << 255.0 * truth.largestError << ")";
  return text.str();
}

std::string ShortlyDescribed(const Truth& truth)
{
  return truth.paths.paths > 0 ? "random paths of scattered light"
                               : "adaptive integral in double precision";
}

}
