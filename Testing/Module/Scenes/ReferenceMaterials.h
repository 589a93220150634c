#ifndef Varimarch_Testing_ReferenceMaterials_h
#define Varimarch_Testing_ReferenceMaterials_h

#include "Core/Geometry/ScalarGrid.h"
#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/MapperScene.h"

#include <functional>
#include <vector>

/// The voxels of a scene of one component in double precision, and VTK's measures of them.
/// Positions are in grid space. Without interpolation the values are those of the nearest voxel.
class SceneSamples
{
public:
  explicit SceneSamples(MapperScene& scene);

  double Value(glm::dvec3 positionGrid) const { return this->Grid().Value(positionGrid); }

  /// Central differences [per voxel].
  glm::dvec3 Gradient(glm::dvec3 positionGrid) const { return this->Grid().Gradient(positionGrid); }

  /// Length of a gradient in VTK's unit: differences per mean spacing.
  double Magnitude(glm::dvec3 gradient) const;

  /// Cosine of the angle between a gradient and the direction to the eye, without its sign.
  double Facing(glm::dvec3 gradient, const varimarch::Ray& rayGrid) const;

  glm::dvec3 NormalWorld(glm::dvec3 gradient) const;
  glm::dvec3 ToEyeWorld(const varimarch::Ray& rayGrid) const;
  glm::dvec3 PositionWorld(glm::dvec3 positionGrid) const;

  const varimarch::VolumeGeometry& Geometry() const { return this->geometry; }
  varimarch::ScalarGrid<double> Grid() const
  {
    return { this->voxels.data(), this->geometry.dimensions };
  }

private:
  varimarch::VolumeGeometry geometry;
  std::vector<double> voxels;
};

/// The optical properties that scenes of one component show by VTK's definitions, written without
/// any formula of the mapper, for MapperScene::TruthOf. The scene must outlive them.

/// The part of a light that reaches a point [0, 1].
/// @param towardsWorld  unit vector to the light
/// @param farMm         distance of the light; infinite for one at infinity
using LightReaching =
  std::function<double(glm::dvec3 positionGrid, glm::dvec3 towardsWorld, double farMm)>;

/// The look of positions without light. Values are given apart, so that others than that of the
/// position can be asked for.
struct UnlitLook
{
  std::function<double(glm::dvec3 positionGrid)> value;
  std::function<glm::dvec3(glm::dvec3 positionGrid)> gradient; ///< per voxel
  std::function<varimarch::OpticalProperties(glm::dvec3 positionGrid, double value)> properties;
  /// Where surfaces at a position lie, from which they see what is around them.
  std::function<glm::dvec3(glm::dvec3 positionGrid)> surface;

  varimarch::OpticalProperties At(glm::dvec3 positionGrid) const
  {
    return this->properties(positionGrid, this->value(positionGrid));
  }
};

/// The look of the scene's transfer function, interpolated.
UnlitLook InterpolatedLook(MapperScene& scene);

/// The same of boxes around voxels, each of which has the value and the gradient of its voxel.
UnlitLook LookOfBoxes(MapperScene& scene);

/// A look in the renderer's lights, within the scene's cuts, with the mapper's shadows and ambient
/// occlusion.
/// @param tolerance  of the light that reaches a point
MapperScene::Material DimmedMaterial(MapperScene& scene, const UnlitLook& look, double tolerance);

/// The volume in the renderer's lights that have no ambient light.
MapperScene::Material MaterialInLights(MapperScene& scene);

/// The same where parts of the lights reach a point.
/// @param reaching  without it, all light reaches every point
MapperScene::Material MaterialInShadows(MapperScene& scene, const LightReaching& reaching);

/// The part of a light that the volume lets through, within its cuts. Its voxels and opacities are
/// those at the time of the call.
LightReaching LightThroughVolume(MapperScene& scene, double tolerance);

/// The same in the shadows that the volume casts on itself, within its cuts. Its voxels and
/// opacities are those at the time of the call.
/// @param tolerance  of the light that reaches a point
MapperScene::Material MaterialInOwnShadows(MapperScene& scene, double tolerance);

/// The volume in the renderer's lights, within its cuts, with the mapper's ambient occlusion.
MapperScene::Material OccludedMaterial(MapperScene& scene, double tolerance);

/// The volume in a head light that is damped where the gradient is below the mapper's
/// DampingGradient.
MapperScene::Material DampedMaterial(MapperScene& scene);

/// The property's function of value and gradient magnitude, shaded by a head light if the property
/// is.
MapperScene::Material MaterialOfTwoValues(MapperScene& scene);

/// The volume where the mapper's binary mask, which has its voxels, is above 0.
MapperScene::Material MaskedMaterial(MapperScene& scene);

/// The volume in a head light, with the property's ClippedVoxelIntensity as value of what the
/// mapper's clipping planes remove.
MapperScene::Material MaterialWithClippedIntensity(MapperScene& scene);

#endif
