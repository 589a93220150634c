#ifndef Varimarch_Scene_ReferenceLighting_h
#define Varimarch_Scene_ReferenceLighting_h

#include "Frame/VolumeGeometry.h"
#include "Scene/Scene.h"

#include <functional>
#include <vector>

class vtkCamera;

namespace varimarch
{

/// A light of a scene in world space.
struct PlacedLight
{
  LightKind kind;
  glm::dvec3 rgb;   ///< times the intensity
  glm::dvec3 place; ///< positional: its position [mm]; else the unit vector towards it. Head: none
  double softnessDegrees; ///< half the angle of its cone; 0: it is a point
};

/// A point of a volume that light falls on, in world space.
struct LitPoint
{
  glm::dvec3 rgb; ///< colour by the transfer function
  glm::dvec3 positionMm;
  glm::dvec3 normal;    ///< unit vector to the falling values; 0 where there is no gradient
  glm::dvec3 toEye;     ///< unit vector
  double gradientPerMm; ///< magnitude [units of the data per mm]
};

/// The part of a light that reaches a point [0, 1].
/// @param towards  unit vector to the light, world space
/// @param farMm    distance of the light; infinite for far lights
using LightReaching = std::function<double(glm::dvec3 towards, double farMm)>;

/// The light of a scene, for the reference: the model of Blinn, "Models of light reflection for
/// computer synthesized pictures" (SIGGRAPH 1977), in double precision and without any formula of
/// the mapper.
struct ReferenceLighting
{
  Shading shading;
  double dampingGradient; ///< see Look [units of the data per mm]
  std::vector<PlacedLight> lights;
  bool lightsBacks;  ///< true if both sides of a surface are lit
  bool castsShadows; ///< true if the volume dims lights that are not at the eye
  /// The part of that which surfaces lack, [0, 1]; the light that matter scatters lacks all of it.
  double surfacesInShadow;
  double reachMm; ///< distance beyond which it does not dim
  /// The part of the light that matter scatters, [0, 1]; surfaces reflect the rest.
  double scatteredPart;
  double anisotropy; ///< see HenyeyGreenstein

  /// True for one white light at the eye without damping.
  bool IsPlainHeadLight() const;

  /// The colour that a point shows to the eye.
  /// @param reaching  asked for lights that are not at the eye; without it, all light arrives
  glm::dvec3 Lit(const LitPoint& point, const LightReaching& reaching = {}) const;
};

/// @param look  the scene's look in units of the data
ReferenceLighting ReferenceLightingOf(
  const Scene& scene, const Look& look, vtkCamera* camera, const VolumeGeometry& geometry);

}

#endif
