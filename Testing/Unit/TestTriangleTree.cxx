// The tree of triangles, walked by packets and by single rays, against all triangles one by one in
// double precision.

#include "Core/Geometry/TriangleTree.h"
#include "Core/Packets/DimmedMaterial.h"
#include "Support/TriangleHits.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

// The hit of a triangle of floats in double precision.
TrueHit HitOf(const Triangle& triangle, const Ray& ray)
{
  const std::array<glm::dvec3, 3> exact = { glm::dvec3(triangle[0]), glm::dvec3(triangle[1]),
    glm::dvec3(triangle[2]) };
  return ::HitOf(exact, ray);
}

constexpr double Grazing = 1e-3; ///< rays that are as near to an edge are not compared

// The nearest triangle; nothing if a ray grazes any edge.
std::optional<TrueHit> NearestOf(const std::vector<Triangle>& triangles, const Ray& ray)
{
  TrueHit nearest;
  for (const Triangle& triangle : triangles)
  {
    const TrueHit hit = HitOf(triangle, ray);
    if (std::abs(hit.inside) < Grazing && hit.t > -1.0)
    {
      return std::nullopt;
    }
    if (hit.inside > 0.0 && hit.t > 0.0 && hit.t < nearest.t)
    {
      nearest = hit;
    }
  }
  return nearest;
}

std::optional<TriangleHit> NearestOfTree(
  const TriangleTree& tree, const Ray& ray, float exit = 1e30f)
{
  return NearestTriangle(
    tree.Texels().data(), glm::vec3(ray.origin), glm::vec3(ray.direction), exit);
}

bool IsMetByLanes(const TriangleTree& tree, const Ray& ray, float exit)
{
  const TreeRays rays = { AllOf3(ray.origin), AllOf3(ray.direction), All(exit) };
  const LaneMask all = AllInt(-1);
  const LaneMask met = MeetTriangles(tree.Texels().data(), rays, all);
  EXPECT_EQ(Any(met), !Any(~met)) << "equal rays differ";
  return Any(met);
}

// Random triangles, of which all lanes and single rays must find the same as brute force.
void ExpectTruth(int count, double side, glm::dvec3 center)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto place = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at = center + 10.0 * place();
    triangles.push_back({ glm::vec3(at + side * place()), glm::vec3(at + side * place()),
      glm::vec3(at + side * place()) });
  }
  const TriangleTree tree(TriangleGroups{ triangles });
  int met = 0;
  int compared = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Ray ray = { glm::dvec3(glm::vec3(center + 15.0 * place())),
      glm::dvec3(glm::vec3(glm::normalize(place()))) };
    const std::optional<TrueHit> truth = NearestOf(triangles, ray);
    if (!truth)
    {
      continue;
    }
    ++compared;
    const std::optional<TriangleHit> found = NearestOfTree(tree, ray);
    const bool isMet = truth->t < 1e30;
    ASSERT_EQ(found.has_value(), isMet) << i;
    ASSERT_EQ(IsMetByLanes(tree, ray, 1e30f), isMet) << i;
    if (isMet)
    {
      ++met;
      EXPECT_NEAR(found->t, truth->t, 1e-3 * std::max(truth->t, 1.0));
      EXPECT_NEAR(HitOf(triangles[found->triangle], ray).t, truth->t, 1e-4) << "another triangle";
      EXPECT_FALSE(IsMetByLanes(tree, ray, float(0.99 * truth->t))) << "beyond the exit";
      EXPECT_TRUE(IsMetByLanes(tree, ray, float(1.01 * truth->t)));
      EXPECT_FALSE(NearestOfTree(tree, ray, float(0.99 * truth->t))) << "beyond the exit";
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(met, 5);
  EXPECT_LT(met, compared);
}

}

TEST(TriangleTree, FindsWhatBruteForceFinds)
{
  for (const int count : { 1, 3, 4, 5, 9, 300 })
  {
    ExpectTruth(count, count < 10 ? 8.0 : 2.0, glm::dvec3(0.0));
  }
}

namespace
{

// Random triangles around a place.
std::vector<Triangle> TrianglesAround(glm::vec3 center, int count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  const auto place = [&] { return glm::vec3(number(random), number(random), number(random)); };
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i)
  {
    const glm::vec3 at = center + 6.0f * place();
    triangles.push_back({ at + place(), at + place(), at + place() });
  }
  return triangles;
}

// The numbers of triangles go on from group to group.
void ExpectTruthOfGroups(const TriangleTree& tree, const TriangleGroups& groups)
{
  std::vector<Triangle> all;
  for (const std::vector<Triangle>& group : groups)
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto place = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  int met = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 from(glm::vec3(30.0 * place()));
    const Ray ray = { from, glm::dvec3(glm::vec3(glm::normalize(20.0 * place() - from))) };
    const std::optional<TrueHit> truth = NearestOf(all, ray);
    if (!truth)
    {
      continue;
    }
    const std::optional<TriangleHit> found = NearestOfTree(tree, ray);
    const bool isMet = truth->t < 1e30;
    ASSERT_EQ(found.has_value(), isMet) << i;
    ASSERT_EQ(IsMetByLanes(tree, ray, 1e30f), isMet) << i;
    if (isMet)
    {
      ++met;
      EXPECT_NEAR(HitOf(all[found->triangle], ray).t, truth->t, 1e-3) << "another triangle";
    }
  }
  EXPECT_GT(met, 50);
}

}

TEST(TriangleTree, FindsTheTrianglesOfAllGroups)
{
  for (const std::size_t count : { 1, 2, 3, 7 })
  {
    TriangleGroups groups(1); // a group may be empty
    for (std::size_t i = 0; i < count; ++i)
    {
      const float x = 8.0f * float(i) - 12.0f;
      groups.push_back(TrianglesAround({ x, 0.0f, -0.5f * x }, 150, unsigned(i)));
    }
    ExpectTruthOfGroups(TriangleTree(groups), groups);
  }
}

TEST(TriangleTree, MovesAGroupToWhereANewTreeHasIt)
{
  TriangleGroups groups = { TrianglesAround({ -12.0f, 0.0f, 0.0f }, 150, 1),
    TrianglesAround({ 12.0f, 0.0f, 0.0f }, 150, 2), TrianglesAround({ 0.0f, 12.0f, 0.0f }, 80, 3) };
  TriangleTree tree(groups);
  for (const std::size_t group : { 1, 0, 2, 1 })
  {
    for (Triangle& triangle : groups[group])
    {
      for (glm::vec3& corner : triangle) // a turn by a right angle, and a shift
      {
        corner = glm::vec3(corner.y + 2.0f, -corner.x, 1.5f * corner.z - 3.0f);
      }
    }
    EXPECT_TRUE(tree.Move(group, groups[group]));
    ExpectTruthOfGroups(tree, groups);
  }
}

TEST(TriangleTree, DoesNotMoveTrianglesIntoNothing)
{
  const TriangleGroups groups = { TrianglesAround(glm::vec3(0.0f), 150, 1) };
  TriangleTree tree(groups);
  EXPECT_FALSE(tree.Move(0, std::vector<Triangle>(150)));
  ExpectTruthOfGroups(tree, groups);
}

// A matrix may flatten an actor, and another one show it again.
TEST(TriangleTree, DoesNotMoveTrianglesOutOfNothing)
{
  const std::vector<Triangle> all = TrianglesAround(glm::vec3(0.0f), 150, 1);
  TriangleGroups groups = { all };
  std::fill(groups[0].begin(), groups[0].begin() + 75, Triangle());
  TriangleTree tree(groups);
  EXPECT_FALSE(tree.Move(0, all));
  ExpectTruthOfGroups(tree, groups);
}

// Coordinates are relative to a place near the volume, so that they are at most some times as large
// as the scene.
TEST(TriangleTree, FindsItFarFromTheOriginToo)
{
  ExpectTruth(100, 3.0, { 300.0, -200.0, 100.0 });
}

// A fan in a plane along two axes, whose boxes are flat, with rays through its inner edges and
// parallel to axes.
TEST(TriangleTree, HasNoGapsBetweenNeighbours)
{
  constexpr int Count = 64;
  std::vector<Triangle> fan;
  for (int i = 0; i < Count; ++i)
  {
    const auto corner = [](int k)
    {
      const double angle = 2.0 * 3.14159265358979 * k / Count;
      return glm::vec3(10.0 * std::cos(angle), 10.0 * std::sin(angle), 1.5);
    };
    fan.push_back({ glm::vec3(0.1f, 0.2f, 1.5f), corner(i), corner((i + 1) % Count) });
  }
  const TriangleTree tree(TriangleGroups{ fan });
  for (int i = 0; i < Count; ++i)
  {
    for (double along = 0.0; along < 0.99; along += 0.01)
    {
      const glm::dvec3 target =
        glm::mix(glm::dvec3(fan[std::size_t(i)][0]), glm::dvec3(fan[std::size_t(i)][1]), along);
      for (const glm::dvec3& direction :
        { glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.3, -0.4, 1.0), glm::dvec3(5.0, 3.0, 1.0) })
      {
        EXPECT_TRUE(IsMetByLanes(tree, { target - direction, direction }, 2.0f));
        EXPECT_FALSE(IsMetByLanes(tree, { target + direction, direction }, 1e30f));
      }
    }
  }
  EXPECT_FALSE(IsMetByLanes(tree, { { -20.0, 0.0, 1.5 }, { 1.0, 0.0, 0.0 } }, 1e30f))
    << "a ray in the plane";
}

TEST(TriangleTree, LeavesOutWhatHasNoArea)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const glm::vec3 a(0.0f);
  const glm::vec3 b(1.0f, 0.0f, 0.0f);
  const glm::vec3 c(0.0f, 1.0f, 0.0f);
  const Ray ray = { { 0.2, 0.2, -1.0 }, { 0.0, 0.0, 1.0 } };
  const std::vector<Triangle> none = { { a, a, a }, { a, b, 2.0f * b },
    { a, b, glm::vec3(0.0f, nan, 0.0f) }, { a, b, glm::vec3(infinite, 1.0f, 0.0f) } };
  EXPECT_FALSE(IsMetByLanes(TriangleTree(TriangleGroups{ none }), ray, 1e30f));
  EXPECT_FALSE(NearestOfTree(TriangleTree(TriangleGroups{ none }), ray));
  EXPECT_FALSE(IsMetByLanes(TriangleTree(), ray, 1e30f));
  std::vector<Triangle> one = none;
  one.push_back({ a, b, c });
  const TriangleTree tree(TriangleGroups{ one });
  EXPECT_TRUE(IsMetByLanes(tree, ray, 1e30f));
  const auto found = NearestOfTree(tree, ray);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->triangle, none.size()) << "numbers count what is left out";
}

TEST(TriangleTree, RefusesMoreTrianglesThanFloatsCount)
{
  EXPECT_THROW(
    TriangleTree(TriangleGroups{ std::vector<Triangle>(TriangleTree::MostTriangles + 1) }),
    std::invalid_argument);
}
