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

/// The view of a reference image, with pixels and rays as the mapper has them.
struct ReferenceView
{
  PixelRays rays;
  glm::dmat3 worldFromGridDirection; ///< transform of directions to world space [mm]
  int width;                         ///< [pixels]
  int height;
};

struct ReferenceImage
{
  int width;
  int height;
  std::vector<float> rgba; ///< premultiplied; the first row is the lowest
  double largestError;     ///< largest of the pixels' error estimates
};

/// Receives the finished fraction of the work, (0, 1]; returns false to cancel. Never called by two
/// threads at once.
using ProgressFunction = std::function<bool(double)>;

/// The colour of a pixel by its ray. It may be called by several threads at once.
/// @param mmPerParameter  length of the ray's direction in the world [mm]
/// @param limits          the part of the ray between the near and the far plane
/// @param pixel           number of the pixel, row by row
using PixelColor = std::function<ReferenceColor(
  const Ray& rayGrid, double mmPerParameter, Interval limits, std::size_t pixel)>;

/// Computes the colour of each pixel by the ray through its centre, on all cores.
/// @return nothing if `progress` cancelled
/// @throws std::invalid_argument for an image without pixels
std::optional<ReferenceImage> DrawPixels(
  const PixelColor& color, const ReferenceView& view, const ProgressFunction& progress = {});

/// Integrates the ray through each pixel's centre, on all cores.
/// @return nothing if `progress` cancelled
/// @throws std::invalid_argument for an image without pixels
std::optional<ReferenceImage> DrawReference(const ReferenceIntegrator& integrator,
  const ReferenceView& view, const ProgressFunction& progress = {});

}

#endif
