#ifndef Varimarch_Core_Reference_PathTracer_h
#define Varimarch_Core_Reference_PathTracer_h

#include "Core/Geometry/Box.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace varimarch
{

/// The phase function of Henyey and Greenstein, "Diffuse radiation in the galaxy" (Astrophysical
/// Journal 93, 1941), with a mean of 1 over the sphere.
/// @param cosine      of the angle by which light is turned: 1 if it goes straight on
/// @param anisotropy  mean of this cosine, (-1, 1)
double HenyeyGreenstein(double cosine, double anisotropy);

/// Upper bounds of the extinction in the cubic bricks of a volume, whose first corner is at 0 in
/// grid space. The outermost bricks reach to infinity.
struct Majorants
{
  double cellsPerBrick;
  glm::ivec3 brickCount;
  std::vector<double> extinctions; ///< [1/mm], x fastest
};

/// A light that shines on every point with the same strength, as those of scenes do.
struct PathLight
{
  bool isDistant;
  glm::dvec3 place; ///< world space: distant: unit vector towards it; else its position [mm]
  glm::dvec3 rgb;
  double softnessRadians = 0.0; ///< half the angle of the cone that it comes from
};

/// Matter that scatters light, and the lights around it.
struct ScatteringScene
{
  Box boxGrid;
  glm::dmat4 worldFromGrid;
  Majorants majorants;
  /// The albedo, [0, 1], and the extinction at a place, which is at most its majorant.
  std::function<OpticalProperties(glm::dvec3 positionGrid)> matter;
  /// See ReferenceScene.
  std::function<std::vector<Interval>(const Ray& rayGrid, Interval inside)> uncutParts = {};
  double anisotropy = 0.0; ///< see HenyeyGreenstein
  std::vector<PathLight> lights;
  glm::dvec3 environment = glm::dvec3(0.0); ///< radiance from all directions, which no eye sees
  /// 1: light is scattered once on its way to the eye.
  int mostScatterings = std::numeric_limits<int>::max();
};

/// The light that matter scatters to the eye, once or any number of times, by random paths. Free
/// paths are those of Woodcock's method, and transmittances those of ratio tracking (Novák, Selle,
/// Jarosz: "Residual ratio tracking for estimating attenuation in participating media", SIGGRAPH
/// Asia 2014), both with a majorant for each brick. Its mean is exact, and it estimates its own
/// deviation. It is the truth of scattering, and far too slow for anything else.
class PathTracer
{
public:
  /// @throws std::invalid_argument for an anisotropy that is not inside (-1, 1)
  explicit PathTracer(ScatteringScene scene);

  /// The mean of paths that begin with a ray of the eye.
  /// @param limits  the part of the ray in which paths may begin
  /// @param paths   their number, >= 2
  /// @param seed    the same seed gives the same colour
  /// @return the colour, with the largest standard error of a channel
  ReferenceColor Color(const Ray& rayGrid, Interval limits, int paths, std::uint64_t seed) const;

private:
  class Path;

  ScatteringScene scene;
  glm::dmat3 worldFromGridDirection;
  glm::dmat3 gridFromWorldDirection;
};

}

#endif
