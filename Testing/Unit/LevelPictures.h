#ifndef Varimarch_Testing_LevelPictures_h
#define Varimarch_Testing_LevelPictures_h

#include "Core/Quality/LevelBound.h"

#include "Unit/MemorySource.h"
#include "Unit/PacketPictures.h"
#include "Unit/VolumesByChance.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

namespace varimarch
{

inline constexpr glm::ivec2 BoundPixels = glm::ivec2(37, 30);
inline constexpr double StepError = 1e-3; ///< error of steps and floats

inline std::vector<std::int16_t> Voxels(
  const VoxelAt& at, const glm::ivec3& count = PacketPictures::Dimensions)
{
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const double value = at({ i % count.x, i / count.x % count.y, i / count.x / count.y });
    voxels.push_back(std::int16_t(std::lround(std::clamp(value, 0.0, 100.0))));
  }
  return voxels;
}

inline double Wave(const glm::ivec3& place)
{
  return 50.0 + 45.0 * std::sin(0.25 * place.x) * std::cos(0.2 * place.y);
}

inline double Ramp(const glm::ivec3& place)
{
  return 10.0 + 4.0 * place.x;
}

inline TransferFunction Foggy(double opacity, double leastOpacity = 0.01)
{
  return { { { 0.0, { 0.1, 0.2, 0.9 } }, { 100.0, { 1.0, 0.8, 0.2 } } },
    { { 0.0, leastOpacity }, { 100.0, opacity } }, PacketPictures::UnitDistanceMm };
}

inline TransferFunction Steep()
{
  return { { { 0.0, { 1.0, 1.0, 1.0 } } }, { { 50.0, 0.0 }, { 51.0, 1.0 } },
    PacketPictures::UnitDistanceMm };
}

/// A volume of which each block is drawn by its voxels, by its coarse level, or by one between.
class LevelPictures
{
public:
  /// @param reflectance  of surfaces under a light at the eye; none without light
  /// @param between      the level between, of half the voxels along each axis, at every second
  /// voxel of the volume; none without one
  LevelPictures(const VoxelAt& at, const TransferFunction& look,
    const std::optional<glm::dvec4>& reflectance = std::nullopt,
    const std::optional<VoxelAt>& between = std::nullopt)
    : reflectance(reflectance)
    , pictures({ Voxels(at), look, BoundPixels })
    , summary(SummaryOf(MemorySource<std::int16_t>(
                          VoxelType::Int16, Voxels(at), glm::ivec2(PacketPictures::Dimensions)),
        { 1 << 20 }, [](double) {}))
    , middle(between ? MiddleOf(*between) : Middle())
    , looks(this->summary, VoxelType::Int16, this->pictures.Table(),
        reflectance ? std::optional(glm::dot(glm::dvec3(*reflectance), glm::dvec3(1.0)))
                    : std::nullopt,
        this->middle.levels)
  {
    if (reflectance)
    {
      this->pictures.LightFromTheEye();
      this->pictures.scene.parameters.reflectances[0] = *reflectance;
      this->pictures.scene.rule = PacketRule::MaterialLinear;
    }
    this->scenes = { &this->pictures.scene };
    if (between)
    {
      this->AddLevel(
        this->middle.voxels.data(), (PacketPictures::Dimensions + 1) / 2, glm::dvec3(0.0), 2.0);
    }
    const double side = this->summary.coarse.side;
    this->AddLevel(this->summary.coarse.voxels.data(), this->summary.coarse.voxelCount,
      glm::dvec3(0.5 * (side - 1.0)), side);
  }

  const BlockLooks& Looks() const { return this->looks; }

  /// Lets a light at infinity cast shadows. The pictures need a reflectance.
  void LightFrom(const glm::dvec3& towardsWorld)
  {
    const glm::dvec3 towards = glm::normalize(towardsWorld);
    this->CastShadows(towards, true);
    this->lights = { { glm::inverse(this->pictures.WorldFromGrid()) * towards, this->Strength() } };
  }

  /// Lets a lamp near the volume cast shadows. The pictures need a reflectance.
  void LampAt(const glm::dvec3& placeGrid)
  {
    const glm::dmat3 worldFromGrid = this->pictures.WorldFromGrid();
    this->CastShadows(worldFromGrid * placeGrid, false); // the origins are one
    this->lights = { { glm::dvec3(0.0), this->Strength(), std::numeric_limits<double>::infinity(),
      LampPlace{ placeGrid, worldFromGrid } } };
  }

  /// Lets matter within a reach keep light from all around. The pictures need a reflectance.
  void OccludeWithin(double reachMm)
  {
    const glm::dmat3 gridFromWorld = glm::inverse(this->pictures.WorldFromGrid());
    this->lights.clear();
    for (const WeightedDirection& one : SphereQuadrature())
    {
      const glm::dvec3 towardsGrid = gridFromWorld * one.direction;
      for (PacketScene* const scene : this->scenes)
      {
        scene->sky.directions[this->lights.size()] = glm::dvec4(towardsGrid, one.weight);
      }
      this->lights.push_back({ towardsGrid, one.weight * this->Brightest(), reachMm });
    }
    for (PacketScene* const scene : this->scenes)
    {
      scene->sky.strength = 1.0f;
      scene->sky.reachMm = float(reachMm);
      scene->sky.stepMm = 0.5f;
      scene->sky.mostDepth = 20.0f;
    }
  }

  std::vector<float> Draw(const BlockLevels& levels)
  {
    const std::vector<const PacketScene*> drawn(this->scenes.begin(), this->scenes.end());
    for (PacketScene* const scene : this->scenes)
    {
      const bool isOfVoxels = scene == this->scenes.front();
      scene->levels = { drawn.data(), int(drawn.size()),
        isOfVoxels ? glm::mat4(1.0f) : glm::inverse(scene->parameters.ownGridFromRays),
        levels.ofBlocks.data(), levels.count, float(levels.side) };
    }
    return this->pictures.March(InstructionSetsOfProcessor().front());
  }

  /// The level without voxels, which ends at its outermost means.
  std::vector<float> DrawAlone()
  {
    RayParameters& rays = this->pictures.scene.rays;
    const RayParameters whole = rays;
    const double side = this->summary.coarse.side;
    const glm::dvec3 first(0.5 * (side - 1.0));
    rays.boxLowerGrid = first;
    rays.boxUpperGrid = first + side * glm::dvec3(this->summary.coarse.voxelCount - 1);
    const std::vector<float> drawn = this->Draw(this->looks.Coarse());
    rays = whole;
    return drawn;
  }

  std::vector<float> DrawVoxels()
  {
    this->pictures.scene.levels = {};
    return this->pictures.March(InstructionSetsOfProcessor().front());
  }

  LevelBoundScene Scene() const
  {
    PixelRays rays = {};
    const RayParameters& from = this->pictures.scene.rays;
    for (int i = 0; i < 3; ++i)
    {
      rays.startGrid[i] = glm::dvec4(glm::vec4(from.rayStartGrid[i]));
      rays.directionGrid[i] = glm::dvec3(glm::vec3(from.rayDirectionGrid[i]));
    }
    rays.nearPlaneGrid = glm::dvec4(glm::vec4(from.nearPlaneGrid));
    rays.farPlaneGrid = glm::dvec4(glm::vec4(from.farPlaneGrid));
    return { this->looks, rays, BoundPixels, this->pictures.WorldFromGrid(),
      { glm::dvec3(0.0), glm::dvec3(PacketPictures::Dimensions - 1) }, false, this->lights };
  }

  /// The largest difference of a pixel from that of the voxels, less its bound. Colours end at 1,
  /// as they do on a screen.
  double MostBeyond(const BlockLevels& levels)
  {
    return this->MostBeyond(this->Draw(levels), LevelBounds(this->Scene(), levels));
  }

  double MostBeyond(const std::vector<float>& drawn, const std::vector<double>& bounds)
  {
    const std::vector<float> exact = this->DrawVoxels();
    double most = -1.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      const double difference = std::min(exact[i], 1.0f) - double(std::min(drawn[i], 1.0f));
      most = std::max(most, std::abs(difference) - bounds[i / 4]);
    }
    return most;
  }

  double LargestDifference(const BlockLevels& levels)
  {
    const std::vector<float> exact = this->DrawVoxels();
    const std::vector<float> drawn = this->Draw(levels);
    return std::inner_product(
      exact.begin(), exact.end(), drawn.begin(), 0.0,
      [](double one, double other) { return std::max(one, other); },
      [](float one, float other) { return std::abs(double(one) - double(other)); });
  }

private:
  /// The level between the voxels and the coarse one.
  struct Middle
  {
    std::vector<std::int16_t> voxels;
    std::vector<MiddleLevel> levels; ///< one, or none without voxels
  };

  static Middle MiddleOf(const VoxelAt& at)
  {
    const glm::ivec3 count = (PacketPictures::Dimensions + 1) / 2;
    Middle made{ Voxels(at, count), {} };
    const MemorySource<std::int16_t> source(VoxelType::Int16, made.voxels, glm::ivec2(count));
    const auto summary =
      std::make_shared<VolumeSummary>(SummaryOf(source, { 1 << 20 }, [](double) {}));
    made.levels = { { summary, glm::dvec3(0.0), glm::dvec3(2.0) } };
    return made;
  }

  double Strength() const { return this->reflectance->y + this->reflectance->z; }
  double Brightest() const { return this->reflectance->x + this->Strength(); }

  /// @param place  direction to a light at infinity, or place of a lamp, in the world
  void CastShadows(const glm::dvec3& place, bool isDistant)
  {
    constexpr float NoCone = -2.0f;
    this->texels = { glm::vec4(glm::vec3(place), 0.0f), glm::vec4(1.0f, 1.0f, 1.0f, NoCone),
      glm::vec4(1.0f, 1.0f, 1.0f, 0.0f), glm::vec4(1.0f, 0.0f, 0.0f, 0.0f), glm::vec4(0.0f) };
    for (PacketScene* const scene : this->scenes)
    {
      scene->light.shading = PacketShading::Lights;
      scene->light.castsShadows = true;
      scene->textures.lightTexels.inMemory = this->texels.data();
      VolumeParameters& parameters = scene->parameters;
      parameters.distantCount = isDistant ? 1 : 0;
      parameters.nearCount = isDistant ? 0 : 1;
      parameters.diffuseLight = parameters.specularLight = glm::vec3(0.0f);
      parameters.surfacesInShadow = 1.0f;
      parameters.shadowReachMm = std::numeric_limits<float>::max();
      const auto& world = parameters.worldFromGrid;
      parameters.gridFromWorld =
        glm::inverse(glm::dmat3(glm::vec3(world[0]), glm::vec3(world[1]), glm::vec3(world[2])));
      scene->rays.shadowStepMm = 0.25f;
    }
  }

  /// @param first  place of the first voxel in the volume
  /// @param scale  distance of its voxels, in those of the volume
  void AddLevel(
    const void* voxels, const glm::ivec3& voxelCount, const glm::dvec3& first, double scale)
  {
    const glm::dmat4 voxelsFromLevel =
      glm::translate(glm::dmat4(1.0), first) * glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
    const glm::dmat3 worldFromLevel = this->pictures.WorldFromGrid() * glm::dmat3(voxelsFromLevel);
    PacketScene& level = this->levels.emplace_back(this->pictures.scene);
    level.volume.voxels = voxels;
    level.volume.voxelCount = voxelCount;
    level.parameters.ownGridFromRays = glm::inverse(voxelsFromLevel);
    level.parameters.worldFromGrid = worldFromLevel;
    level.parameters.worldOfGridOrigin = this->pictures.WorldFromGrid() * first;
    level.parameters.worldFromGradient = glm::transpose(glm::inverse(worldFromLevel));
    this->scenes.push_back(&level);
  }

  std::optional<glm::dvec4> reflectance;
  PacketPictures pictures;
  VolumeSummary summary;
  Middle middle;
  BlockLooks looks;
  std::deque<PacketScene> levels;   ///< the coarser ones
  std::vector<PacketScene*> scenes; ///< the scenes of all levels
  std::vector<glm::vec4> texels;
  std::vector<LevelLight> lights;
};

inline double LargestOf(const std::vector<double>& bounds)
{
  return *std::max_element(bounds.begin(), bounds.end());
}

/// Refines all pixels.
/// @return the largest bound that is left
inline double RefineAll(const LevelPictures& pictures, double tolerance, BlockLevels& levels)
{
  std::vector<double> bounds(std::size_t(BoundPixels.x * BoundPixels.y), 1.0);
  Refine(pictures.Scene(), { tolerance }, levels, bounds);
  return LargestOf(bounds);
}

inline std::ptrdiff_t CountVoxels(const BlockLevels& levels)
{
  return std::count(levels.ofBlocks.begin(), levels.ofBlocks.end(), BlockLevel::Voxels);
}

}

#endif
