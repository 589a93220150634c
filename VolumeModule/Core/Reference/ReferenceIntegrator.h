#ifndef Varimarch_Core_Reference_ReferenceIntegrator_h
#define Varimarch_Core_Reference_ReferenceIntegrator_h

#include "Core/Geometry/PixelRays.h"
#include "Core/Reference/RayIntegral.h"

#include <glm/mat3x3.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace varimarch
{

/// Computes the exact colour that images are compared with: the volume rendering integral along one
/// ray, in double precision, to a given tolerance. It shares no formula with the shaders.
class ReferenceIntegrator
{
public:
  static constexpr double SmallestTolerance = 1e-12;

  /// @param tolerance  largest accepted error of a premultiplied channel, >= SmallestTolerance
  /// @throws std::invalid_argument for a smaller tolerance or a scene without voxels
  explicit ReferenceIntegrator(const ReferenceScene& scene, double tolerance = 1e-9);

  /// @param rayGrid  ray in grid space
  /// @param mmPerParameter  length of the ray's direction in the world [mm], > 0
  /// @param limits  the part of the ray that counts; it is clipped to the scene's box
  ReferenceColor Color(const Ray& rayGrid, double mmPerParameter,
    Interval limits = { 0.0, std::numeric_limits<double>::infinity() }) const;

private:
  Box boxGrid;
  std::function<std::vector<Interval>(const Ray& rayGrid, Interval inside)> uncutParts;
  std::shared_ptr<const RayIntegral> integral;
};

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
