#include "Core/HeadLightShading.h"
#include "Core/ReferenceIntegrator.h"

#include <gtest/gtest.h>

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
  EXPECT_NEAR(color.r, truth.r, tolerance);
  EXPECT_NEAR(color.g, truth.g, tolerance);
  EXPECT_NEAR(color.b, truth.b, tolerance);
}

}

TEST(HeadLightShading, DependsOnTheAngleInTheWorld)
{
  // Planes x + y = constant in the grid; voxels are twice as high as wide.
  const auto gradient = [](glm::dvec3) { return glm::dvec3(3.0, 3.0, 0.0); };
  const glm::dmat3 worldFromGrid(
    glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 2.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  const HeadLightShading shade(light, gradient, worldFromGrid);
  const glm::dvec3 normalWorld = glm::normalize(glm::dvec3(2.0, 1.0, 0.0));
  ExpectNear(shade(rgb, glm::dvec3(0.0), { 5.0, 0.0, 0.0 }), Lit(normalWorld.x));
  ExpectNear(shade(rgb, glm::dvec3(0.0), { 0.0, -0.1, 0.0 }), Lit(normalWorld.y));
  ExpectNear(shade(rgb, glm::dvec3(0.0), { 0.0, 0.0, 1.0 }), Lit(0.0));
}

TEST(HeadLightShading, LeavesAmbientLightWhereTheGradientVanishes)
{
  const HeadLightShading shade(
    light, [](glm::dvec3) { return glm::dvec3(0.0); }, glm::dmat3(1.0));
  ExpectNear(shade(rgb, glm::dvec3(0.0), { 1.0, 0.0, 0.0 }), 0.1 * rgb);
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
    light, [&](glm::dvec3 position) { return grid.Gradient(position); }, glm::dmat3(1.0));
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
    color += transmittance * (1.0 - through) * shade(rgb, position, ray.direction);
    transmittance *= through;
  }
  const ReferenceColor reference = integrator.Color(ray, 1.0);
  ExpectNear(glm::dvec3(reference.rgba), color, 1e-7);
  EXPECT_LT(reference.error, 1e-8);
}

TEST(HeadLightShading, OneValueOnANodeIsShadedByPlace)
{
  // All voxels lie on a node, so that the whole cell has one extinction, but not one colour.
  const std::vector<double> voxels(8, 1.0);
  const ScalarGrid<double> grid(voxels.data(), glm::ivec3(2));
  const auto brighter = [](glm::dvec3 color, glm::dvec3 position, glm::dvec3)
  { return color * position.x; };
  const ReferenceIntegrator integrator({ [&](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    { glm::dvec3(0.0), glm::dvec3(1.0) }, { {}, { { 0.0, 0.0 }, { 1.0, 0.5 } }, 1.0 },
    Blend::Composite, brighter });
  const double depth = std::log(2.0);
  const double truth = (1.0 - (1.0 + depth) * 0.5) / depth;
  EXPECT_NEAR(integrator.Color({ { -1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 } }, 1.0).rgba.r, truth, 1e-9);
}
