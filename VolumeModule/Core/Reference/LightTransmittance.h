#ifndef Varimarch_Core_Reference_LightTransmittance_h
#define Varimarch_Core_Reference_LightTransmittance_h

#include "Core/Geometry/SphereQuadrature.h"
#include "Core/Reference/ReferenceIntegrator.h"

#include <glm/mat3x3.hpp>

#include <functional>
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

/// The part of the light from all around that a volume lets through to a point, in double
/// precision: the mean over SphereQuadrature of the transmittance over a reach. It is the truth of
/// ambient occlusion.
class SkyVisibility
{
public:
  /// @param transmittance  of the volume; kept by reference
  /// @param reachMm        distance beyond which matter does not count
  SkyVisibility(const LightTransmittance& transmittance, double reachMm)
    : transmittance(transmittance)
    , reachMm(reachMm)
  {
  }

  /// @return [0, 1]
  double At(glm::dvec3 positionGrid) const;

private:
  const LightTransmittance& transmittance;
  double reachMm;
};

/// The place from which a surface sees what is around it: two voxels along its gradient, up or
/// down.
/// @param gradient      per voxel
/// @param isThinnerUp   see the function of this name
glm::dvec3 OutsideOf(glm::dvec3 positionGrid, glm::dvec3 gradient, bool isThinnerUp);

/// True if there would be less matter a voxel up a gradient than a voxel down it, by more than a
/// hundredth.
/// @param gradient      per voxel
/// @param extinctionOf  the extinction where the value is another
bool IsThinnerUp(
  double value, glm::dvec3 gradient, const std::function<double(double value)>& extinctionOf);

/// The part of its light that a place keeps: V / (V + strength (1 - V)) for the visibility V.
double KeptLight(double visibility, double strength);

}

#endif
