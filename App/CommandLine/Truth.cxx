#include "Truth.h"

#include "Scene/ReferenceCache.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace varimarch
{

Truth TruthOf(const Scene& scene, vtkImageData* image, const OnStep& onStep)
{
  // A thousandth of the rounding of an 8-bit display, far below the errors that are compared.
  constexpr double Tolerance = 1e-6;
  const auto start = std::chrono::steady_clock::now();
  const auto onProgress = [&](double done)
  {
    onStep("Integrating the reference, " + std::to_string(std::lround(100.0 * done)) + " %");
    return true;
  };
  const auto reference = ReferenceCache().Picture(scene, image, Tolerance, onProgress);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return { reference->image, reference->largestError, elapsed.count() };
}

std::string Described(const Truth& truth)
{
  std::ostringstream text;
  text.precision(1);
  text << "an adaptive integral of each ray in double precision (largest error estimate "
       << std::scientific << 255.0 * truth.largestError << ")";
  return text.str();
}

}
