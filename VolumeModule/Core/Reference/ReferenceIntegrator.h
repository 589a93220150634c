#ifndef Varimarch_Core_Reference_ReferenceIntegrator_h
#define Varimarch_Core_Reference_ReferenceIntegrator_h

#include "Core/Reference/RayIntegral.h"

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

}

#endif
