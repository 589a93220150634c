#include "Core/Look/HeadLightShading.h"
#include "Core/Reference/CellPieces.h"
#include "Unit/ReferenceVolumes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace varimarch;

namespace
{

const HeadLight light{ glm::dvec3(0.1), glm::dvec3(0.6, 0.7, 0.8), glm::dvec3(0.3), 20.0 };
const glm::dvec3 rgb(0.9, 0.5, 0.2);

glm::dvec3 Lit(double cosine)
{
  return rgb * (light.ambient + cosine * light.diffuse) +
    std::pow(cosine, light.specularPower) * light.specular;
}

void ExpectNear(glm::dvec3 color, glm::dvec3 truth, double tolerance = 1e-14)
{
  varimarch::ExpectNear(glm::dvec4(color, 1.0), glm::dvec4(truth, 1.0), tolerance);
}

/// Emission halfway through the unit cell, in a field with a constant gradient.
glm::dvec3 EmittedWith(
  glm::dvec3 gradient, glm::dvec3 directionGrid, const glm::dmat3& worldFromGrid = glm::dmat3(1.0))
{
  const HeadLightShading shade(
    light,
    [=](glm::ivec3)
    {
      std::array<CellCorners, 3> gradients;
      for (int axis = 0; axis < 3; ++axis)
      {
        gradients[axis].fill(gradient[axis]);
      }
      return gradients;
    },
    worldFromGrid);
  return shade({ glm::ivec3(0), { 0.0, 0.1 } }, { glm::dvec3(0.5), directionGrid })
    .emitted(rgb, 0.5);
}

}

TEST(HeadLightShading, DependsOnTheAngleInTheWorld)
{
  // Planes x + y = constant in the grid; voxels are twice as high as wide.
  const glm::dvec3 gradient(3.0, 3.0, 0.0);
  const glm::dmat3 worldFromGrid(
    glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 2.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec3 normalWorld = glm::normalize(glm::dvec3(2.0, 1.0, 0.0));
  ExpectNear(EmittedWith(gradient, { 5.0, 0.0, 0.0 }, worldFromGrid), Lit(normalWorld.x));
  ExpectNear(EmittedWith(gradient, { 0.0, -0.1, 0.0 }, worldFromGrid), Lit(normalWorld.y));
  ExpectNear(EmittedWith(gradient, { 0.0, 0.0, 1.0 }, worldFromGrid), Lit(0.0));
}

TEST(HeadLightShading, LeavesAmbientLightWhereTheGradientVanishes)
{
  ExpectNear(EmittedWith(glm::dvec3(0.0), { 1.0, 0.0, 0.0 }), 0.1 * rgb);
}

TEST(HeadLightShading, LeavesAmbientLightBesideAVoxelThatIsNotFinite)
{
  for (const double bad : { infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    ExpectNear(EmittedWith({ 1.0, bad, 0.0 }, { 1.0, 0.0, 0.0 }), 0.1 * rgb);
  }
}

TEST(HeadLightShading, HasTheGradientOfTheGridAnywhere)
{
  std::mt19937 random(12);
  const ReferenceVolume volume = RandomVolume({ 4, 3, 5 }, random);
  for (int i = 0; i < 100; ++i)
  {
    const Ray ray = RandomRay(volume.dimensions, random);
    const Interval inside = Intersection(ray, volume.BoxGrid());
    if (inside.IsEmpty())
    {
      continue;
    }
    WalkCells(ray, inside,
      [&](const CellPart& part)
      {
        const auto gradients = GradientsOfCell(volume.Grid(), part.cell);
        const double u = 0.3, t = part.t.enter + u * (part.t.exit - part.t.enter);
        const glm::dvec3 truth = volume.Grid().Gradient(ray.origin + t * ray.direction);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(PieceOf(part, gradients[axis], ray).cubic.Value(u), truth[axis], 1e-13);
        }
        return true;
      });
  }
}

TEST(HeadLightShading, IsIntegratedAsAMarchOfTinyStepsDoes)
{
  std::mt19937 random(11);
  std::vector<double> voxels(5 * 5 * 5);
  for (double& voxel : voxels)
  {
    voxel = std::uniform_real_distribution<double>(0.0, 1.0)(random);
  }
  const ScalarGrid<double> grid(voxels.data(), glm::ivec3(5));
  const TransferFunction transferFunction({ { 0.0, rgb } }, { { 0.2, 0.0 }, { 0.9, 0.7 } }, 1.0);
  const HeadLightShading shade(
    light, [&](glm::ivec3 cell) { return GradientsOfCell(grid, cell); }, glm::dmat3(1.0));
  const ReferenceIntegrator integrator({ [&](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    { glm::dvec3(0.0), glm::dvec3(4.0) }, transferFunction, Blend::Composite, shade });
  const Ray ray{ { -1.0, 0.3, 0.4 }, glm::normalize(glm::dvec3(1.0, 0.5, 0.6)) };

  const Interval inside = Intersection(ray, { glm::dvec3(0.0), glm::dvec3(4.0) });
  const int steps = 40000;
  const double step = (inside.exit - inside.enter) / steps;
  glm::dvec3 color(0.0);
  double transmittance = 1.0;
  for (int k = 0; k < steps; ++k)
  {
    const glm::dvec3 position = ray.origin + (inside.enter + (k + 0.5) * step) * ray.direction;
    const double through = std::exp(-transferFunction.Extinction(grid.Value(position)) * step);
    const glm::dvec3 normal = glm::normalize(grid.Gradient(position));
    color += transmittance * (1.0 - through) * Lit(std::abs(glm::dot(normal, ray.direction)));
    transmittance *= through;
  }
  const ReferenceColor reference = integrator.Color(ray, 1.0);
  ExpectNear(glm::dvec3(reference.rgba), color, 1e-7);
  EXPECT_LT(reference.error, 1e-8);
}

TEST(HeadLightShading, OneValueOnANodeIsShadedByPlace)
{
  // All voxels lie on a node, so that the cell has one extinction but several colours.
  const std::vector<double> voxels(8, 1.0);
  const ScalarGrid<double> grid(voxels.data(), glm::ivec3(2));
  const auto brighter = [](glm::dvec3 color, glm::dvec3 position, glm::dvec3)
  { return color * position.x; };
  const ReferenceIntegrator integrator({ [&](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    { glm::dvec3(0.0), glm::dvec3(1.0) }, { {}, { { 0.0, 0.0 }, { 1.0, 0.5 } }, 1.0 },
    Blend::Composite, LightByPlace(brighter) });
  const double depth = std::log(2.0);
  const double truth = (1.0 - (1.0 + depth) * 0.5) / depth;
  EXPECT_NEAR(integrator.Color({ { -1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 } }, 1.0).rgba.r, truth, 1e-9);
}
