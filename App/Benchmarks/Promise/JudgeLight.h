#ifndef Varimarch_Promise_JudgeLight_h
#define Varimarch_Promise_JudgeLight_h

#include "JudgeScene.h"

namespace varimarch
{

/// A place in a volume at which the judge asks for light.
struct JudgePlace
{
  int volume;
  const JudgeSpan* span;
  double u; ///< in the span
  glm::dvec3 world;
  glm::dvec3 toEye; ///< unit vector
};

/// The effect of light on a colour, which is multiplied by one number and to which the other is
/// added.
struct JudgedLight
{
  glm::dvec3 ofColor = glm::dvec3(1.0);
  glm::dvec3 highlight = glm::dvec3(0.0);
};

/// Light at places of a scene, by a ray of its own for each direction that it comes from.
class JudgeLight
{
public:
  /// @param pieces  equal parts into which each smooth piece of a ray is divided, >= 1
  JudgeLight(const JudgeScene& scene, int pieces)
    : scene(scene)
    , pieces(pieces)
  {
  }

  JudgedLight At(const JudgePlace& place) const;

  /// The part of the light that the volumes let through along a ray, [0, 1].
  double Transmittance(const JudgeRay& ray, double farMm) const;

  /// The part of the light from all around that reaches a place, [0, 1].
  double Visibility(glm::dvec3 world) const;

private:
  double DepthOf(const JudgeVolume& volume, const JudgeSpan& span) const;
  double Reaching(const JudgeLamp& lamp, glm::dvec3 world, glm::dvec3 toLight, double farMm) const;
  void AddLamp(
    JudgedLight& light, const JudgeLamp& lamp, const JudgePlace& place, glm::dvec3 outward) const;
  double KeptAt(const JudgePlace& place) const;

  const JudgeScene& scene;
  int pieces;
};

/// The first place behind the origin of a ray that lies on one of the triangles [mm]; infinite if
/// none does.
double JudgedHit(const std::vector<JudgeTriangle>& triangles, const JudgeRay& ray);

}

#endif
