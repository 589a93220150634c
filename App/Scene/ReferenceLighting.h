#ifndef Varimarch_Scene_ReferenceLighting_h
#define Varimarch_Scene_ReferenceLighting_h

#include "Scene/Scene.h"

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

/// The light of a scene, for the reference: the model of Blinn, "Models of light reflection for
/// computer synthesized pictures" (SIGGRAPH 1977), in double precision and without any formula of
/// the mapper.
struct ReferenceLighting
{
  Shading shading;
  double dampingGradient; ///< see Look [units of the data per mm]
  std::vector<PlacedLight> lights;
  bool lightsBacks; ///< true if both sides of a surface are lit

  /// True for one white light at the eye without damping.
  bool IsPlainHeadLight() const;

  /// The colour that a point shows to the eye.
  glm::dvec3 Lit(const LitPoint& point) const;
};

/// @param look  in units of the data
ReferenceLighting ReferenceLightingOf(
  const Look& look, const std::vector<SceneLight>& lights, vtkCamera* camera);

}

#endif
