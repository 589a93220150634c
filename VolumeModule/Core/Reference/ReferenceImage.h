#ifndef Varimarch_Core_Reference_ReferenceImage_h
#define Varimarch_Core_Reference_ReferenceImage_h

#include "Core/Geometry/PixelRays.h"
#include "Core/Reference/ReferenceIntegrator.h"

#include <glm/mat3x3.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace varimarch
{

/// Where a reference image is taken from: pixels and rays as the mapper has them.
struct ReferenceView
{
  PixelRays rays;
  glm::dmat3 worldFromGridDirection; ///< the world in mm
  int width;                         ///< pixels
  int height;
};

struct ReferenceImage
{
  int width;
  int height;
  std::vector<float> rgba; ///< premultiplied, row 0 is the lowest
  double largestError;     ///< the largest of the pixels' error estimates
};

/// Told the part of the work that is done, (0, 1]; returns false to give up. Never called by two
/// threads at a time.
using ProgressFunction = std::function<bool(double)>;

/// Integrates the ray of every pixel's centre, on all cores.
/// @return nothing when `progress` gave up
/// @throws std::invalid_argument for an image without pixels
std::optional<ReferenceImage> DrawReference(const ReferenceIntegrator& integrator,
  const ReferenceView& view, const ProgressFunction& progress = {});

}

#endif
