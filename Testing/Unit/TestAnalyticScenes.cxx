// The reference integrator against closed forms of whole rays.

#include "Core/Geometry/CellWalk.h"
#include "Support/AnalyticScenes.h"
#include "Unit/ReferenceVolumes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

ReferenceScene ReferenceOf(const AnalyticScene& scene, const std::vector<double>& voxels)
{
  const ScalarGrid<double> grid(voxels.data(), scene.Dimensions());
  return { [grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); }, scene.BoxGrid(),
    scene.transferFunction };
}

/// Compares one ray, given in grid space.
/// @return true if anything is visible along the ray
bool ExpectClosedForm(const AnalyticScene& scene, const ReferenceScene& reference, const Ray& ray)
{
  const Interval inside = Intersection(ray, scene.BoxGrid());
  if (inside.IsEmpty())
  {
    return false;
  }
  const double mmPerParameter = glm::length(ray.direction * scene.spacingMm);
  const glm::dvec4 truth = scene.Color({ ray, mmPerParameter, { inside } });
  ExpectNear(ColorAlong(reference, ray, mmPerParameter), truth);
  return truth.a > 0.01;
}

}

class ReferenceOfAnAnalyticScene : public testing::TestWithParam<AnalyticScene>
{
protected:
  const AnalyticScene& scene = GetParam();
  const std::vector<double> voxels = scene.Voxels();
  const ReferenceScene reference = ReferenceOf(scene, voxels);
};

TEST_P(ReferenceOfAnAnalyticScene, HasTheClosedFormAlongAnyRay)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  const glm::dvec3 size(this->scene.Dimensions() - 1);
  const auto place = [&](double scale)
  { return size * (0.5 + scale * glm::dvec3(number(random), number(random), number(random))); };
  int seen = 0;
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec3 origin = place(4.0);
    seen += ExpectClosedForm(this->scene, this->reference, { origin, place(1.0) - origin });
  }
  EXPECT_GT(seen, 50);
}

TEST_P(ReferenceOfAnAnalyticScene, HasTheClosedFormAlongItsFacesAndEdges)
{
  const glm::dvec3 size(this->scene.Dimensions() - 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double across : { 0.0, 1.0, 1.5, 2.0 })
    {
      Ray ray{ glm::dvec3(across), glm::dvec3(0.0) };
      ray.origin[axis] = -2.0;
      ray.direction[axis] = 1.0;
      ExpectClosedForm(this->scene, this->reference, ray);
      ray.origin[axis] = size[axis] + 2.0;
      ray.direction[axis] = -1.0;
      ExpectClosedForm(this->scene, this->reference, ray);
    }
  }
  ExpectClosedForm(this->scene, this->reference, { glm::dvec3(-1.0), size + 2.0 });
}

TEST_P(ReferenceOfAnAnalyticScene, HasTheClosedFormAtGrazingAngles)
{
  // Rays pass the ball, shell or corner at distances down to a millionth of a voxel.
  const glm::dvec3 middle = 0.5 * glm::dvec3(this->scene.Dimensions() - 1);
  for (double miss = 1.0; miss > 1e-6; miss *= 0.3)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Ray ray{ middle + glm::dvec3(-20.0, 7.1 + side * miss, 0.3 * miss),
        { 1.0, 1e-3, 2e-4 } };
      ExpectClosedForm(this->scene, this->reference, ray);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ReferenceOfAnAnalyticScene, testing::ValuesIn(AnalyticScenes()),
  [](const auto& info)
  {
    std::string name = info.param.name;
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
  });

TEST(AnalyticPiece, WithRisingExtinctionHasAnErrorFunction)
{
  // With b the increase of extinction per mm, the mean of T is
  // sqrt(pi / (2 b)) / l exp(a^2 / (2 b)) (erf((a + b l) / sqrt(2 b)) - erf(a / sqrt(2 b))).
  for (const double a : { 0.0, 0.3, 1.0 })
  {
    for (const double l : { 0.5, 2.0, 6.0 })
    {
      const double b = 0.7, root = std::sqrt(2.0 * b);
      const double mean = std::sqrt(std::acos(-1.0)) / root / l * std::exp(a * a / (2.0 * b)) *
        (std::erf((a + b * l) / root) - std::erf(a / root));
      const double transmittance = std::exp(-a * l - 0.5 * b * l * l);
      const glm::dvec4 color = LinearPieceColor({ red, a }, { blue, a + b * l }, l);
      ExpectNear(color, { 1.0 - mean, 0.0, mean - transmittance, 1.0 - transmittance }, 1e-14);
    }
  }
}

TEST(AnalyticPiece, CutAnywhereIsTheSame)
{
  const OpticalProperties front{ red, 5.0 }, back{ blue, 0.0 };
  const double l = 3.0, part = 0.3;
  const OpticalProperties middle{ (1.0 - part) * red + part * blue, 5.0 * (1.0 - part) };
  const glm::dvec4 first = LinearPieceColor(front, middle, part * l);
  const glm::dvec4 second = LinearPieceColor(middle, back, (1.0 - part) * l);
  ExpectNear(first + (1.0 - first.a) * second, LinearPieceColor(front, back, l), 1e-14);
}

TEST(AnalyticScene, BallsHaveTheFormsOfTheSmoothBallButForTheirVoxels)
{
  // Interpolated squares are too large by at most 1/4 per axis, so the level sets are inscribed.
  for (const AnalyticScene& scene : AnalyticScenes())
  {
    const Ray ray{ { -5.0, 8.0, 8.0 }, { 1.0, 0.0, 0.0 } };
    const double alpha = scene.Color({ ray, 1.0, { Intersection(ray, scene.BoxGrid()) } }).a;
    if (scene.name == "ball")
    {
      EXPECT_NEAR(alpha, 1.0 - std::exp(-0.2 * 2.0 * 7.1), 0.01);
    }
    if (scene.name == "Gaussian ball")
    {
      const double depth =
        0.5 * std::sqrt(18.0 * std::acos(-1.0)) * std::erf(8.0 / std::sqrt(18.0));
      EXPECT_NEAR(alpha, 1.0 - std::exp(-depth), 0.01);
    }
  }
}

TEST(Reference, ColorAffineInOpticalDepthHasAClosedFormInAnyField)
{
  // A manufactured solution: extinction equals the value, so that the optical depth is the integral
  // of a cubic in each cell, and the colour is p + q tau.
  const double unitMm = 1e-12, p = 0.2, q = 0.5;
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i)
  {
    const ReferenceVolume volume = RandomVolume({ 5, 4, 6 }, random);
    const Ray ray = RandomRay(volume.dimensions, random);
    const Interval inside = Intersection(ray, volume.BoxGrid());
    const auto depthTo = [&](double t)
    {
      // Two Gauss points are exact for a cubic.
      double depth = 0.0;
      WalkCells(ray, { inside.enter, t },
        [&](const CellPart& part)
        {
          const double length = part.t.exit - part.t.enter;
          for (const double point : { 0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0) })
          {
            const double at = part.t.enter + point * length;
            depth += 0.5 * length * volume.Grid().Value(ray.origin + at * ray.direction);
          }
          return true;
        });
      return depth;
    };
    ReferenceScene scene =
      SceneOf(volume, { {}, { { 0.0, 0.0 }, { 1.0, -std::expm1(-unitMm) } }, unitMm });
    scene.shade = LightByPlace(
      [&](glm::dvec3, glm::dvec3 position, glm::dvec3 direction)
      {
        const double t =
          glm::dot(position - ray.origin, direction) / glm::dot(direction, direction);
        return glm::dvec3(p + q * depthTo(t));
      });
    const double depth = inside.IsEmpty() ? 0.0 : depthTo(inside.exit);
    const double alpha = -std::expm1(-depth);
    const double color = (p + q) * alpha - q * depth * (1.0 - alpha);
    ExpectNear(ColorAlong(scene, ray), { color, color, color, alpha });
  }
}
