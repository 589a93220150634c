#include "Core/Geometry/PixelRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

const Box box{ glm::dvec3(0.0), glm::dvec3(63.0, 31.0, 15.0) };

// Distance of a point from the line of a ray in grid units.
double Distance(const Ray& ray, glm::dvec3 point)
{
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const glm::dvec3 offset = point - ray.origin;
  return glm::length(offset - glm::dot(offset, direction) * direction);
}

// Requires that every point lies on the ray of the pixel that it projects to, that the rays point
// away from the eye, and that the near plane lies in front of them.
void ExpectRaysThroughTheirPixels(const glm::dmat4& clipFromGrid)
{
  const PixelRays rays = ComputePixelRays(clipFromGrid, box);
  for (const glm::dvec3& point :
    { glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(60.0, 30.0, 1.0), glm::dvec3(31.5, 15.5, 7.5) })
  {
    const glm::dvec4 clip = clipFromGrid * glm::dvec4(point, 1.0);
    const Ray ray = rays.At(clip.x / clip.w, clip.y / clip.w);
    EXPECT_LT(Distance(ray, point), 1e-9);
    const glm::dvec4 farther =
      clipFromGrid * glm::dvec4(point + 0.01 * glm::normalize(ray.direction), 1.0);
    EXPECT_GT(farther.z / farther.w, clip.z / clip.w);
    EXPECT_GT(glm::dot(rays.nearPlaneGrid, glm::dvec4(point, 1.0)), 0.0);
  }
}

const glm::dmat4 view = glm::lookAt(
  glm::dvec3(200.0, -150.0, 90.0), glm::dvec3(30.0, 15.0, 7.0), glm::dvec3(0.0, 0.0, 1.0));
const glm::dmat4 sheared =
  glm::dmat4(0.5, 0.0, 0.0, 0.0, 0.1, 0.7, 0.0, 0.0, 0.0, 0.2, -2.0, 0.0, 5.0, 6.0, 7.0, 1.0);

}

TEST(PixelRays, PassThroughTheirPixelsInPerspective)
{
  const glm::dmat4 projection = glm::perspective(glm::radians(30.0), 1.3, 50.0, 500.0);
  ExpectRaysThroughTheirPixels(projection * view);
  ExpectRaysThroughTheirPixels(projection * view * sheared);
}

TEST(PixelRays, PassThroughTheirPixelsInParallelProjection)
{
  const glm::dmat4 projection = glm::ortho(-60.0, 60.0, -40.0, 40.0, 50.0, 500.0);
  ExpectRaysThroughTheirPixels(projection * view);
  ExpectRaysThroughTheirPixels(projection * view * sheared);
}

TEST(PixelRays, PassThroughTheirPixelsOffAxis)
{
  ExpectRaysThroughTheirPixels(glm::frustum(-10.0, 30.0, -5.0, 20.0, 50.0, 500.0) * view);
}

TEST(PixelRays, StartAtTheVolumeHoweverFarTheEyeIs)
{
  const glm::dmat4 distant =
    glm::lookAt(glm::dvec3(1e6, 0.0, 7.0), glm::dvec3(0.0, 15.0, 7.0), glm::dvec3(0.0, 0.0, 1.0));
  const glm::dmat4 clipFromGrid = glm::perspective(glm::radians(0.01), 1.0, 9e5, 2e6) * distant;
  const Ray ray = ComputePixelRays(clipFromGrid, box).At(0.0, 0.0);
  EXPECT_LT(glm::length(ray.origin - glm::dvec3(63.0, 15.0, 7.0)), 100.0);
}

TEST(PixelRays, StartAtTheNearPlaneWhenTheEyeIsInside)
{
  const glm::dmat4 inside = glm::lookAt(
    glm::dvec3(30.0, 15.0, 7.0), glm::dvec3(60.0, 15.0, 7.0), glm::dvec3(0.0, 0.0, 1.0));
  const glm::dmat4 clipFromGrid = glm::perspective(glm::radians(60.0), 1.0, 0.5, 100.0) * inside;
  const Ray ray = ComputePixelRays(clipFromGrid, box).At(0.0, 0.0);
  EXPECT_NEAR(ray.origin.x, 30.5, 1e-9);
}

TEST(PixelRays, LieBetweenTheNearAndTheFarPlane)
{
  for (const glm::dmat4& projection : { glm::perspective(glm::radians(30.0), 1.0, 180.0, 300.0),
         glm::ortho(-60.0, 60.0, -60.0, 60.0, 180.0, 300.0) })
  {
    const glm::dmat4 along =
      glm::lookAt(glm::dvec3(-200.0, 15.0, 7.0), glm::dvec3(0.0, 15.0, 7.0), glm::dvec3(0, 0, 1));
    const PixelRays rays = ComputePixelRays(projection * along, box);
    const Ray ray = rays.At(0.0, 0.0);
    const Interval between = rays.BetweenPlanes(ray);
    EXPECT_NEAR(ray.origin.x, 0.0, 1e-9) << "rays start at the volume";
    EXPECT_EQ(between.enter, 0.0);
    EXPECT_NEAR(ray.origin.x + between.exit * ray.direction.x, 100.0, 1e-9);
  }
}

TEST(PixelRays, RefuseAMatrixWithoutAnInverse)
{
  EXPECT_THROW(ComputePixelRays(glm::dmat4(0.0), box), std::invalid_argument);
}

TEST(PixelRays, ComeFromTheEye)
{
  const glm::dmat4 perspective = glm::perspective(glm::radians(30.0), 1.3, 50.0, 500.0);
  const glm::dvec4 eye = ComputePixelRays(perspective * view, box).eyeGrid;
  EXPECT_GT(eye.w, 0.0);
  EXPECT_LT(glm::length(glm::dvec3(eye) / eye.w - glm::dvec3(200.0, -150.0, 90.0)), 1e-8);

  // The eye is infinitely far away, on the side of the camera.
  const glm::dmat4 parallel = glm::ortho(-60.0, 60.0, -40.0, 40.0, 50.0, 500.0);
  for (double flip : { 1.0, -1.0 }) // a homogeneous matrix may have either sign
  {
    const glm::dvec4 farEye = ComputePixelRays(flip * (parallel * view), box).eyeGrid;
    for (double face : { 0.0, 63.0 })
    {
      EXPECT_GT(farEye.x, face * farEye.w);
      EXPECT_LT(farEye.y, face * farEye.w);
      EXPECT_GT(farEye.z, face * farEye.w);
    }
  }
}
