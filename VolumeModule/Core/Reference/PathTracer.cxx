#include "Core/Reference/PathTracer.h"

#include "Core/Reference/CellPieces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

double HenyeyGreenstein(double cosine, double anisotropy)
{
  const double squared = anisotropy * anisotropy;
  const double distance = 1.0 + squared - 2.0 * anisotropy * cosine;
  return (1.0 - squared) / (distance * std::sqrt(distance));
}

/// One path, whose rays count in mm.
class PathTracer::Path
{
public:
  Path(const PathTracer& tracer, std::mt19937_64& random)
    : tracer(tracer)
    , scene(tracer.scene)
    , random(random)
  {
  }

  /// The colour of a path that begins in a part of a ray.
  glm::dvec4 Color(const Ray& rayGrid, Interval limitsMm);

private:
  struct Collision
  {
    glm::dvec3 positionGrid;
    glm::dvec3 albedo;
  };

  double Uniform() { return std::uniform_real_distribution<double>()(this->random); }

  template <class Visit>
  void WalkBricks(const Ray& rayGrid, Interval limitsMm, Visit visit) const;
  template <class Visit>
  void WalkTentative(const Ray& rayGrid, Interval limitsMm, Visit visit);
  std::optional<Collision> NextCollision(const Ray& rayGrid, Interval limitsMm);
  double Transmittance(const Ray& rayGrid, double farMm);
  glm::dvec3 FromLights(glm::dvec3 positionGrid, glm::dvec3 alongWorld);
  double ScatteredCosine();
  glm::dvec3 Turned(glm::dvec3 alongWorld, double cosine);
  bool GoesOn(int scatterings, glm::dvec3& part);
  Ray RayFrom(glm::dvec3 positionGrid, glm::dvec3 directionWorld) const
  {
    return { positionGrid, this->tracer.gridFromWorldDirection * directionWorld };
  }

  const PathTracer& tracer;
  const ScatteringScene& scene;
  std::mt19937_64& random;
};

// Calls visit(majorant, part) for the bricks along a ray until it returns false.
template <class Visit>
void PathTracer::Path::WalkBricks(const Ray& rayGrid, Interval limitsMm, Visit visit) const
{
  const Interval inside = Intersection(rayGrid, this->scene.boxGrid, limitsMm);
  if (inside.IsEmpty())
  {
    return;
  }
  const std::vector<Interval> parts = this->scene.uncutParts
    ? this->scene.uncutParts(rayGrid, inside)
    : std::vector<Interval>{ inside };
  const Majorants& majorants = this->scene.majorants;
  const Ray inBricks{ rayGrid.origin / majorants.cellsPerBrick,
    rayGrid.direction / majorants.cellsPerBrick };
  WalkCells(MeasuredRay{ inBricks, 1.0, parts },
    [&](const CellPart& part)
    {
      const glm::ivec3 brick =
        glm::clamp(part.cell, glm::ivec3(0), majorants.brickCount - glm::ivec3(1));
      const std::size_t row = std::size_t(brick.z) * majorants.brickCount.y + brick.y;
      return visit(majorants.extinctions[row * majorants.brickCount.x + brick.x], part.t);
    });
}

// Calls visit(place, matter there, majorant) for random places, whose number per length is the
// majorant, until it returns false.
template <class Visit>
void PathTracer::Path::WalkTentative(const Ray& rayGrid, Interval limitsMm, Visit visit)
{
  this->WalkBricks(rayGrid, limitsMm,
    [&](double majorant, Interval part)
    {
      if (majorant <= 0.0)
      {
        return true;
      }
      std::exponential_distribution<double> lengthMm(majorant);
      for (double t = part.enter + lengthMm(this->random); t < part.exit;
           t += lengthMm(this->random))
      {
        const glm::dvec3 place = rayGrid.origin + t * rayGrid.direction;
        if (!visit(place, this->scene.matter(place), majorant))
        {
          return false;
        }
      }
      return true;
    });
}

std::optional<PathTracer::Path::Collision> PathTracer::Path::NextCollision(
  const Ray& rayGrid, Interval limitsMm)
{
  std::optional<Collision> collision;
  this->WalkTentative(rayGrid, limitsMm,
    [&](glm::dvec3 place, const OpticalProperties& matter, double majorant)
    {
      if (this->Uniform() * majorant < matter.extinction)
      {
        collision = { place, matter.rgb };
      }
      return !collision;
    });
  return collision;
}

double PathTracer::Path::Transmittance(const Ray& rayGrid, double farMm)
{
  constexpr double Little = 0.05;
  double left = 1.0;
  this->WalkTentative(rayGrid, { 0.0, farMm },
    [&](glm::dvec3, const OpticalProperties& matter, double majorant)
    {
      left *= std::max(1.0 - matter.extinction / majorant, 0.0);
      // Little light survives by chance, and then counts as much as that which does not.
      if (left < Little)
      {
        left = this->Uniform() * Little < left ? Little : 0.0;
      }
      return left > 0.0;
    });
  return left;
}

glm::dvec3 PathTracer::Path::FromLights(glm::dvec3 positionGrid, glm::dvec3 alongWorld)
{
  glm::dvec3 sum(0.0);
  for (const PathLight& light : this->scene.lights)
  {
    glm::dvec3 towards = light.place;
    double farMm = std::numeric_limits<double>::infinity();
    if (!light.isDistant)
    {
      const glm::dvec3 toLight =
        light.place - glm::dvec3(this->scene.worldFromGrid * glm::dvec4(positionGrid, 1.0));
      farMm = glm::length(toLight);
      towards = toLight / farMm;
    }
    // The path goes against the light: both turns have the same angle.
    const double phase = HenyeyGreenstein(glm::dot(towards, alongWorld), this->scene.anisotropy);
    if (light.softnessRadians > 0.0)
    {
      towards =
        this->Turned(towards, 1.0 - (1.0 - std::cos(light.softnessRadians)) * this->Uniform());
    }
    sum += phase * this->Transmittance(this->RayFrom(positionGrid, towards), farMm) * light.rgb;
  }
  return sum;
}

// The cosine by which light is turned, whose density is the phase function.
double PathTracer::Path::ScatteredCosine()
{
  const double g = this->scene.anisotropy;
  const double random = 2.0 * this->Uniform() - 1.0;
  if (std::abs(g) < 1e-4)
  {
    return random;
  }
  const double part = (1.0 - g * g) / (1.0 + g * random);
  return std::clamp((1.0 + g * g - part * part) / (2.0 * g), -1.0, 1.0);
}

// A direction at an angle to another one.
glm::dvec3 PathTracer::Path::Turned(glm::dvec3 along, double cosine)
{
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double angle = glm::two_pi<double>() * this->Uniform();
  const glm::dvec3 other =
    std::abs(along.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 first = glm::normalize(glm::cross(along, other));
  return glm::normalize(
    cosine * along + sine * (std::cos(angle) * first + std::sin(angle) * glm::cross(along, first)));
}

// Paths of little influence end by chance; the others then count more.
bool PathTracer::Path::GoesOn(int scatterings, glm::dvec3& part)
{
  constexpr int SurelyFollowed = 4;
  const double influence = std::min(std::max({ part.x, part.y, part.z }), 1.0);
  if (scatterings < SurelyFollowed || influence == 0.0)
  {
    return influence > 0.0;
  }
  part /= influence;
  return this->Uniform() < influence;
}

glm::dvec4 PathTracer::Path::Color(const Ray& rayGrid, Interval limitsMm)
{
  const Interval everywhere{ 0.0, std::numeric_limits<double>::infinity() };
  std::optional<Collision> collision = this->NextCollision(rayGrid, limitsMm);
  const double alpha = collision ? 1.0 : 0.0;
  glm::dvec3 along = this->tracer.worldFromGridDirection * rayGrid.direction;
  glm::dvec3 rgb(0.0);
  glm::dvec3 part(1.0);
  for (int scatterings = 1; collision && scatterings <= this->scene.mostScatterings; ++scatterings)
  {
    part *= collision->albedo;
    rgb += part * this->FromLights(collision->positionGrid, along);
    if (!this->GoesOn(scatterings, part))
    {
      break;
    }
    along = this->Turned(along, this->ScatteredCosine());
    collision = this->NextCollision(this->RayFrom(collision->positionGrid, along), everywhere);
    rgb += collision ? glm::dvec3(0.0) : part * this->scene.environment;
  }
  return { rgb, alpha };
}

PathTracer::PathTracer(ScatteringScene givenScene)
  : scene(std::move(givenScene))
  , worldFromGridDirection(this->scene.worldFromGrid)
  , gridFromWorldDirection(glm::inverse(this->worldFromGridDirection))
{
  if (!(std::abs(this->scene.anisotropy) < 1.0))
  {
    throw std::invalid_argument("Path tracer: the anisotropy must be between -1 and 1, found " +
      std::to_string(this->scene.anisotropy));
  }
}

ReferenceColor PathTracer::Color(
  const Ray& rayGrid, Interval limits, int paths, std::uint64_t seed) const
{
  const double mmPerParameter = glm::length(this->worldFromGridDirection * rayGrid.direction);
  const Ray ray{ rayGrid.origin, rayGrid.direction / mmPerParameter };
  const Interval limitsMm{ limits.enter * mmPerParameter, limits.exit * mmPerParameter };
  std::mt19937_64 random(seed);
  // Welford's sums: squares of differences from the mean do not cancel.
  glm::dvec4 mean(0.0);
  glm::dvec4 squares(0.0);
  for (int path = 1; path <= paths; ++path)
  {
    const glm::dvec4 color = Path(*this, random).Color(ray, limitsMm);
    const glm::dvec4 difference = color - mean;
    mean += difference / double(path);
    squares += difference * (color - mean);
  }
  const double largest = std::max({ squares.x, squares.y, squares.z, squares.w });
  return { mean, std::sqrt(largest / (double(paths) * (paths - 1.0))) };
}

}
