// Poses of the camera on a walk through the volume.

#include "Scene/Model/WorldVector.h"
#include "Viewer/Tools/MouseTool.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

TEST(Walking, GoesAlongTheAxesOfTheView)
{
  const CameraPose pose = { { 1.0, 2.0, 3.0 }, { 1.0, 2.0, -7.0 }, { 0.0, 1.0, 0.0 }, 1.0 };
  const CameraPose walked = Walked(pose, { 5.0, 7.0, 11.0 });
  EXPECT_NEAR(glm::distance(VectorOf(walked.positionMm), glm::dvec3(6.0, 9.0, -8.0)), 0.0, 1e-12);
  EXPECT_NEAR(
    glm::distance(VectorOf(walked.focalPointMm), glm::dvec3(6.0, 9.0, -18.0)), 0.0, 1e-12);
}

TEST(Walking, LooksToTheRightAndUpButNotOverhead)
{
  const CameraPose pose = { { 1.0, 2.0, 3.0 }, { 1.0, 2.0, -7.0 }, { 0.0, 1.0, 0.0 }, 1.0 };
  const auto seen = [&](double right, double up)
  {
    const CameraPose looking = LookingAround(pose, right, up);
    return VectorOf(looking.focalPointMm) - VectorOf(looking.positionMm);
  };
  EXPECT_NEAR(glm::distance(seen(90.0, 0.0), glm::dvec3(10.0, 0.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(
    glm::distance(seen(0.0, 30.0), 10.0 * glm::dvec3(0.0, 0.5, -std::sqrt(0.75))), 0.0, 1e-12);
  EXPECT_NEAR(seen(0.0, 200.0).y, 10.0 * std::sin(glm::radians(85.0)), 1e-12);
}
