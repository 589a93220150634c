#ifndef Varimarch_Promise_Judge_h
#define Varimarch_Promise_Judge_h

#include "JudgeScene.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

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

/// The truth of pixels, by an integrator in double precision that shares nothing with the mapper
/// but the meaning of a scene (Documentation/Mathematics.md): it has its own reading of VTK's
/// objects, its own interpolation, and a ray of its own from every place at which light is asked
/// for.
///
/// A ray is cut at the faces of cells, at cuts, and at all nodes of functions. The smooth pieces
/// between are integrated by Gauss' rule of three points, in parts of less than half an optical
/// depth. How much two finenesses differ tells the judge's own error.
class Judge
{
public:
  /// @param scene  must outlive the judge
  explicit Judge(const JudgeScene& scene)
    : scene(scene)
  {
  }

  /// A fineness that asks for light only once for each piece.
  static constexpr int Coarse = 0;

  /// Premultiplied RGBA of the volumes at a place of the picture, without what is behind them.
  /// @param pixels    place, from the lower left corner; centres are at halves
  /// @param fineness  Coarse, or the number of parts of each smooth piece
  glm::dvec4 Pixel(glm::dvec2 pixels, int fineness) const;

  /// True if the ray of a place meets opaque geometry.
  bool MeetsGeometry(glm::dvec2 pixels) const;

private:
  struct View
  {
    JudgeRay ray;
    double from;
    double to;
  };
  View ViewOf(glm::dvec2 pixels) const;

  const JudgeScene& scene;
};

/// The composite along a part of a ray.
glm::dvec4 JudgedComposite(
  const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part, int fineness);

/// The other blend modes along a part of a ray, of a scene with one volume.
glm::dvec4 JudgedProjection(
  const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part, int fineness);

}

#endif
