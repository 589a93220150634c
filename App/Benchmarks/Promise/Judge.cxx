#include "Judge.h"

#include <vtkVolumeMapper.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

Judge::View Judge::ViewOf(glm::dvec2 pixels) const
{
  const double x = 2.0 * pixels.x / this->scene.width - 1.0;
  const double y = 2.0 * pixels.y / this->scene.height - 1.0;
  const glm::dvec4 atNear = this->scene.worldFromClip * glm::dvec4(x, y, -1.0, 1.0);
  const glm::dvec4 atFar = this->scene.worldFromClip * glm::dvec4(x, y, 1.0, 1.0);
  const glm::dvec3 from = glm::dvec3(atNear) / atNear.w;
  const glm::dvec3 way = glm::dvec3(atFar) / atFar.w - from;
  const JudgeRay ray{ from, glm::normalize(way) };
  const double hit = this->scene.seen.empty() ? glm::length(way) : JudgedHit(this->scene.seen, ray);
  return { ray, 0.0, std::min(glm::length(way), hit) };
}

bool Judge::MeetsGeometry(glm::dvec2 pixels) const
{
  const View view = this->ViewOf(pixels);
  return std::isfinite(JudgedHit(this->scene.seen, view.ray));
}

glm::dvec4 Judge::Pixel(glm::dvec2 pixels, int fineness) const
{
  const View view = this->ViewOf(pixels);
  const auto judged =
    this->scene.blendMode == vtkVolumeMapper::COMPOSITE_BLEND ? JudgedComposite : JudgedProjection;
  return judged(this->scene, view.ray, { view.from, view.to }, fineness);
}

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double DeepEnough = 25.0; // no light is left

struct Weighted
{
  glm::dvec3 direction;
  double weight;
};

// Stroud's rule U3 9-1, turned by a radian about (1, 2, 3), as Documentation/Mathematics.md defines
// ambient occlusion: the corners of an icosahedron and of its dual dodecahedron.
std::vector<Weighted> SphereRule()
{
  const double golden = glm::golden_ratio<double>();
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 1.0, glm::dvec3(1.0, 2.0, 3.0)));
  std::vector<Weighted> rule;
  const auto add = [&](glm::dvec3 corner, double weight) {
    rule.push_back({ turn * glm::normalize(corner), weight });
  };
  for (int signs = 0; signs < 8; ++signs)
  {
    const double a = (signs & 1) != 0 ? 1.0 : -1.0;
    const double b = (signs & 2) != 0 ? 1.0 : -1.0;
    add({ a, b, (signs & 4) != 0 ? 1.0 : -1.0 }, 9.0 / 280.0);
    if (signs < 4)
    {
      for (const glm::dvec3 corner : { glm::dvec3(a, b * golden, 0.0),
             glm::dvec3(0.0, a, b * golden), glm::dvec3(b * golden, 0.0, a) })
      {
        add(corner, 5.0 / 168.0);
      }
      for (const glm::dvec3 corner : { glm::dvec3(a * golden, b / golden, 0.0),
             glm::dvec3(0.0, a * golden, b / golden), glm::dvec3(b / golden, 0.0, a * golden) })
      {
        add(corner, 9.0 / 280.0);
      }
    }
  }
  return rule;
}

// Stroud's rule S2 7-1 on the disc, mapped to a cone without a change of areas. The axes of the
// disc are those of Duff and others (2017), which belong to the definition of soft light.
std::vector<Weighted> ConeRule(glm::dvec3 axis, double degrees)
{
  const double side = axis.z < 0.0 ? -1.0 : 1.0;
  const double a = -1.0 / (side + axis.z);
  const double b = axis.x * axis.y * a;
  const glm::dvec3 first(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x);
  const glm::dvec3 second(b, side + axis.y * axis.y * a, -axis.y);
  const double height = 1.0 - std::cos(glm::radians(degrees));
  std::vector<Weighted> rule;
  const auto add = [&](double x, double y, double weight)
  {
    const double squared = x * x + y * y;
    const double across = std::sqrt(height * (2.0 - height * squared));
    rule.push_back({ (1.0 - height * squared) * axis + across * (x * first + y * second), weight });
  };
  const double root = std::sqrt(29.0);
  for (const double sign : { -1.0, 1.0 })
  {
    add(sign * std::sqrt(0.75), 0.0, 2.0 / 27.0);
    add(0.0, sign * std::sqrt(0.75), 2.0 / 27.0);
    for (const double other : { -1.0, 1.0 })
    {
      const double inner = std::sqrt((27.0 - 3.0 * root) / 104.0);
      const double outer = std::sqrt((27.0 + 3.0 * root) / 104.0);
      add(sign * inner, other * inner, (551.0 + 41.0 * root) / 6264.0);
      add(sign * outer, other * outer, (551.0 - 41.0 * root) / 6264.0);
    }
  }
  return rule;
}

// The method of Möller and Trumbore.
double HitOf(const JudgeTriangle& triangle, const JudgeRay& ray)
{
  const glm::dvec3 one = triangle[1] - triangle[0];
  const glm::dvec3 other = triangle[2] - triangle[0];
  const glm::dvec3 across = glm::cross(ray.direction, other);
  const double volume = glm::dot(one, across);
  const glm::dvec3 from = ray.origin - triangle[0];
  const double u = glm::dot(from, across) / volume;
  const glm::dvec3 up = glm::cross(from, one);
  const double v = glm::dot(ray.direction, up) / volume;
  const double t = glm::dot(other, up) / volume;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : Infinite;
}

// The part of a near light that reaches a distance, within its cone.
double StrengthAt(const JudgeLamp& lamp, glm::dvec3 toLight, double distance)
{
  constexpr double WidestCone = 90.0;
  const double inCone = -glm::dot(toLight, lamp.shinesAlong);
  const bool hasCone = lamp.coneDegrees < WidestCone;
  if (hasCone && inCone < std::cos(glm::radians(lamp.coneDegrees)))
  {
    return 0.0;
  }
  const double shaped = hasCone ? std::pow(std::max(inCone, 0.0), lamp.exponent) : 1.0;
  return shaped /
    (lamp.attenuation.x + distance * (lamp.attenuation.y + distance * lamp.attenuation.z));
}

double PhaseOf(double cosine, double g)
{
  return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

}

double JudgedHit(const std::vector<JudgeTriangle>& triangles, const JudgeRay& ray)
{
  double first = Infinite;
  for (const JudgeTriangle& triangle : triangles)
  {
    first = std::min(first, HitOf(triangle, ray));
  }
  return first;
}

double JudgeLight::DepthOf(const JudgeVolume& volume, const JudgeSpan& span) const
{
  static const double Offset = 0.5 * std::sqrt(0.6); // Gauss' rule of three points
  thread_local std::vector<JudgePiece> found;
  volume.FindPieces(span, found);
  double depth = 0.0;
  for (const JudgePiece& piece : found)
  {
    const int parts = volume.isNearest ? 1 : this->pieces;
    const double width = (piece.to - piece.from) / parts;
    for (int i = 0; i < parts; ++i)
    {
      const double middle = piece.from + (i + 0.5) * width;
      const auto at = [&](double offset)
      { return volume.ExtinctionAt(span, *piece.band, middle + offset * width); };
      depth += width * (8.0 * at(0.0) + 5.0 * (at(-Offset) + at(Offset))) / 18.0;
    }
  }
  return depth * (span.exit - span.enter);
}

double JudgeLight::Transmittance(const JudgeRay& ray, double farMm) const
{
  double depth = 0.0;
  for (const JudgeVolume& volume : this->scene.volumes)
  {
    volume.WalkVisible(ray, 0.0, farMm,
      [&](const JudgeSpan& span)
      {
        depth += this->DepthOf(volume, span);
        return depth < DeepEnough;
      });
  }
  return std::exp(-depth);
}

double JudgeLight::Visibility(glm::dvec3 world) const
{
  static const std::vector<Weighted> Rule = SphereRule();
  double sum = 0.0;
  for (const Weighted& one : Rule)
  {
    sum += one.weight * this->Transmittance({ world, one.direction }, this->scene.occlusionReachMm);
  }
  return sum;
}

// The mean over the directions that a light comes from, through the volumes and past geometry.
double JudgeLight::Reaching(
  const JudgeLamp& lamp, glm::dvec3 world, glm::dvec3 toLight, double farMm) const
{
  const std::vector<Weighted> directions = lamp.softnessDegrees > 0.0
    ? ConeRule(toLight, lamp.softnessDegrees)
    : std::vector<Weighted>{ { toLight, 1.0 } };
  double sum = 0.0;
  for (const Weighted& one : directions)
  {
    const JudgeRay ray{ world, one.direction };
    const bool isFree = !this->scene.hasShadows || JudgedHit(this->scene.casting, ray) >= farMm;
    sum += isFree ? one.weight * this->Transmittance(ray, farMm) : 0.0;
  }
  return sum;
}

void JudgeLight::AddLamp(
  JudgedLight& light, const JudgeLamp& lamp, const JudgePlace& place, glm::dvec3 outward) const
{
  const JudgeVolume& volume = this->scene.volumes[std::size_t(place.volume)];
  const double distance = lamp.isNear ? glm::length(lamp.position - place.world) : Infinite;
  const glm::dvec3 toLight = lamp.isAtEye
    ? place.toEye
    : (lamp.isNear ? (lamp.position - place.world) / distance : -lamp.shinesAlong);
  const double strength = lamp.isNear ? StrengthAt(lamp, toLight, distance) : 1.0;
  if (strength == 0.0)
  {
    return;
  }
  const auto facing = [&](glm::dvec3 direction)
  {
    const double cosine = glm::dot(outward, direction);
    return this->scene.isTwoSided ? std::abs(cosine) : std::max(cosine, 0.0);
  };
  const bool isDimmed = !lamp.isAtEye && (this->scene.hasShadows || this->scene.Scatters());
  const double farMm =
    this->scene.hasShadows ? distance : std::min(distance, this->scene.scatterReachMm);
  const double reaching =
    isDimmed && farMm > 0.0 ? this->Reaching(lamp, place.world, toLight, farMm) : 1.0;
  const double shadow =
    this->scene.hasShadows ? 1.0 - this->scene.shadowStrength * (1.0 - reaching) : 1.0;
  const double scattered = this->scene.scatteredPart;
  const double phase =
    scattered > 0.0 ? PhaseOf(-glm::dot(toLight, place.toEye), this->scene.anisotropy) : 0.0;
  const double reflected = (1.0 - scattered) * shadow;
  light.ofColor += volume.diffuse * strength *
    (reflected * facing(toLight) + scattered * phase * reaching) * lamp.diffuse;
  const glm::dvec3 halfway = toLight + place.toEye;
  const double shining =
    facing(toLight) > 0.0 ? facing(halfway) / std::max(glm::length(halfway), 1e-15) : 0.0;
  light.highlight += volume.specular * strength * reflected *
    (shining > 0.0 ? std::pow(std::min(shining, 1.0), volume.specularPower) : 0.0) * lamp.specular;
}

// Ambient occlusion: light is seen from two voxels outside of a surface, on the side on which there
// is less matter a voxel away by more than a hundredth. No matter has values beyond those of the
// voxels.
double JudgeLight::KeptAt(const JudgePlace& place) const
{
  const JudgeVolume& volume = this->scene.volumes[std::size_t(place.volume)];
  const JudgeSpan& span = *place.span;
  const glm::dvec3 gradient = volume.GradientAt(span, place.u);
  const double change = glm::length(gradient);
  const JudgeLook& look = volume.looks[std::size_t(span.look)];
  const double value = ValueOf(span.value, place.u);
  const auto matter = [&](double wanted)
  {
    const double other = std::clamp(wanted, volume.leastValue, volume.mostValue);
    return -std::log1p(-std::min(look.Opacity(look[look.BandOf(other)], other), 1.0));
  };
  glm::dvec3 grid(volume.gridFromWorld * glm::dvec4(place.world, 1.0));
  grid = volume.isNearest ? glm::dvec3(span.cell) : grid;
  if (change > 0.0)
  {
    constexpr double OutsideVoxels = 2.0;
    constexpr double Less = 0.99;
    const bool isThinnerUp = matter(value + change) < Less * matter(value - change);
    grid += (isThinnerUp ? OutsideVoxels : -OutsideVoxels) / change * gradient;
  }
  const double seen = this->Visibility(glm::dvec3(volume.worldFromGrid * glm::dvec4(grid, 1.0)));
  return seen / (seen + this->scene.occlusion * (1.0 - seen));
}

JudgedLight JudgeLight::At(const JudgePlace& place) const
{
  const JudgeVolume& volume = this->scene.volumes[std::size_t(place.volume)];
  JudgedLight light;
  if (volume.isShaded)
  {
    const glm::dvec3 inward =
      glm::transpose(glm::dmat3(volume.gridFromWorld)) * volume.GradientAt(*place.span, place.u);
    const double length = glm::length(inward);
    const glm::dvec3 outward = length > 0.0 ? -inward / length : glm::dvec3(0.0);
    light.ofColor = volume.ambient * this->scene.ambientLight;
    for (const JudgeLamp& lamp : this->scene.lamps)
    {
      this->AddLamp(light, lamp, place, outward);
    }
  }
  if (this->scene.occlusion > 0.0)
  {
    const double kept = this->KeptAt(place);
    light.ofColor *= kept;
    light.highlight *= kept;
  }
  return light;
}

}
