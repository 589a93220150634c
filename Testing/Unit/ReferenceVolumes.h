#ifndef Varimarch_Testing_ReferenceVolumes_h
#define Varimarch_Testing_ReferenceVolumes_h

#include "Core/Reference/ReferenceIntegrator.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

// Small volumes and rays for the tests of the reference.

namespace varimarch
{

constexpr double infinity = std::numeric_limits<double>::infinity();
inline const glm::dvec3 red(1.0, 0.0, 0.0);
inline const glm::dvec3 blue(0.0, 0.0, 1.0);

struct ReferenceVolume
{
  glm::ivec3 dimensions;
  std::vector<double> voxels;

  ScalarGrid<double> Grid() const { return { this->voxels.data(), this->dimensions }; }
  Box BoxGrid() const { return { glm::dvec3(0.0), glm::dvec3(this->dimensions - 1) }; }
};

/// A scene of `volume`, which must outlive it.
inline ReferenceScene SceneOf(const ReferenceVolume& volume, TransferFunction transferFunction)
{
  return { [&volume](glm::ivec3 cell) { return CornersOfCell(volume.Grid(), cell); },
    volume.BoxGrid(), std::move(transferFunction) };
}

inline glm::dvec4 ColorAlong(const ReferenceScene& scene, const Ray& ray,
  double mmPerParameter = 1.0, Interval limits = { 0.0, infinity })
{
  const ReferenceColor color = ReferenceIntegrator(scene).Color(ray, mmPerParameter, limits);
  EXPECT_LT(color.error, 1e-8);
  return color.rgba;
}

inline void ExpectNear(glm::dvec4 color, glm::dvec4 truth, double tolerance = 1e-8)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(color[channel], truth[channel], tolerance) << "channel " << channel;
  }
}

/// A ramp of values from 0 at x = 0 to 1 at x = cells.
inline ReferenceVolume RampAlongX(int cells)
{
  ReferenceVolume volume{ { cells + 1, 2, 2 }, {} };
  for (int i = 0; i < 4 * (cells + 1); ++i)
  {
    volume.voxels.push_back(double(i % (cells + 1)) / cells);
  }
  return volume;
}

inline const Ray alongX{ { -1.0, 0.3, 0.6 }, { 1.0, 0.0, 0.0 } };

inline ReferenceVolume RandomVolume(glm::ivec3 dimensions, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(0.0, 1.0);
  ReferenceVolume volume{ dimensions,
    std::vector<double>(dimensions.x * dimensions.y * dimensions.z) };
  for (double& voxel : volume.voxels)
  {
    voxel = value(random);
  }
  return volume;
}

inline Ray RandomRay(glm::ivec3 dimensions, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(0.0, 1.0);
  const auto place = [&](double scale)
  { return glm::dvec3(number(random), number(random), number(random)) * scale - 0.5 * scale; };
  const glm::dvec3 origin = glm::dvec3(dimensions - 1) * 0.5 + place(10.0);
  return { origin, glm::dvec3(dimensions - 1) * 0.5 + place(1.5) - origin };
}

/// For ReferenceScene::shade: emission as a function of (rgb, position, direction).
template <class Emitted>
auto LightByPlace(Emitted emitted)
{
  return [emitted](const CellPart& part, const Ray& ray)
  {
    return PieceLight{ [=](glm::dvec3 rgb, double u)
      {
        const double t = part.t.enter + u * (part.t.exit - part.t.enter);
        return emitted(rgb, ray.origin + t * ray.direction, ray.direction);
      } };
  };
}

}

#endif
