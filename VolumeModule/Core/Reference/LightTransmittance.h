#ifndef Varimarch_Core_Reference_LightTransmittance_h
#define Varimarch_Core_Reference_LightTransmittance_h

#include "Core/Reference/ReferenceIntegrator.h"

#include <glm/mat3x3.hpp>

#include <limits>

namespace varimarch
{

/// The part of a light that a volume lets through to a point: exp(-optical depth between them), in
/// double precision. Together with ReferenceScene::material it is the truth of shadows.
class LightTransmittance
{
public:
  /// @param scene      its opacities and cuts; light in it does not matter
  /// @param tolerance  largest accepted error, >= ReferenceIntegrator::SmallestTolerance
  LightTransmittance(
    ReferenceScene scene, const glm::dmat3& gridFromWorldDirection, double tolerance);

  /// @param towardsWorld  unit vector to the light
  /// @param farMm         distance of the light [mm]
  /// @return [0, 1]
  double Towards(glm::dvec3 positionGrid, glm::dvec3 towardsWorld,
    double farMm = std::numeric_limits<double>::infinity()) const;

private:
  glm::dmat3 gridFromWorldDirection;
  ReferenceIntegrator integrator;
};

}

#endif
