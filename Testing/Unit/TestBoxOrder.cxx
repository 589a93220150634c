#include "Core/Blocks/BoxOrder.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace varimarch;

namespace
{

constexpr Box UnitCube{ glm::dvec3(0.0), glm::dvec3(1.0) };

// Cuts boxes at random places until there are `count` of them. A cut goes through one box only, so
// that no boxes hide each other in a circle.
std::vector<Box> CutAtRandom(int count, std::mt19937& random)
{
  std::vector<Box> boxes{ UnitCube };
  std::uniform_real_distribution<double> fraction(0.2, 0.8);
  while (static_cast<int>(boxes.size()) < count)
  {
    Box& cut = boxes[random() % boxes.size()];
    const int axis = static_cast<int>(random() % 3);
    const double place = glm::mix(cut.lower[axis], cut.upper[axis], fraction(random));
    Box upper = cut;
    upper.lower[axis] = place;
    cut.upper[axis] = place;
    boxes.push_back(upper);
  }
  std::shuffle(boxes.begin(), boxes.end(), random);
  return boxes;
}

// Where a ray is in each box, in the order in which boxes are given.
std::vector<Interval> Passages(
  const std::vector<Box>& boxes, const std::vector<int>& order, const Ray& ray)
{
  std::vector<Interval> passages;
  for (int box : order)
  {
    const Interval passage = Intersection(ray, boxes[box]);
    if (passage.exit - passage.enter > 1e-9)
    {
      passages.push_back(passage);
    }
  }
  return passages;
}

void ExpectOrderAlongRays(
  const std::vector<Box>& boxes, const glm::dvec4& eye, std::mt19937& random)
{
  const std::vector<int> order = FrontToBack(boxes, eye);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  ASSERT_EQ(sorted, all);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (int i = 0; i < 50; ++i)
  {
    const glm::dvec3 target(place(random), place(random), place(random));
    const bool isParallel = eye.w == 0.0;
    const glm::dvec3 direction = isParallel ? -glm::dvec3(eye) : target - glm::dvec3(eye);
    const glm::dvec3 origin = isParallel ? target - 10.0 * direction : glm::dvec3(eye);
    const std::vector<Interval> passages = Passages(boxes, order, { origin, direction });
    EXPECT_TRUE(std::is_sorted(passages.begin(), passages.end(),
      [](const Interval& a, const Interval& b) { return a.exit < b.exit; }));
  }
}

}

TEST(BoxOrder, HasBoxesInTheOrderOfEachRay)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.5, 2.5);
  for (int i = 0; i < 60; ++i)
  {
    const std::vector<Box> boxes = CutAtRandom(2 + i % 20, random);
    EXPECT_FALSE(FirstOverlap(boxes));
    const glm::dvec4 point(place(random), place(random), place(random), i % 2);
    ExpectOrderAlongRays(boxes, point, random);
  }
}

TEST(BoxOrder, TakesTheNearestOfBoxesThatHideEachOtherInACircle)
{
  // Bars along x, y and z. The first hides a part of the second, the second of the third, and the
  // third of the first.
  const std::vector<Box> boxes{ { { 0, 0, 1 }, { 3, 1, 2 } }, { { 1, 0, 0 }, { 2, 3, 1 } },
    { { 0, 1, 0 }, { 1, 2, 3 } } };
  const std::vector<int> fromTheFirst{ 0, 1, 2 };
  EXPECT_EQ(FrontToBack(boxes, glm::dvec4(1.2, 1.0, 1.1, 0.0)), fromTheFirst);
}

TEST(BoxOrder, FindsBoxesThatOverlap)
{
  Box other{ glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(2.0, 1.0, 1.0) };
  EXPECT_FALSE(FirstOverlap({ UnitCube, other }));
  other.lower.x = 1.0 - 1e-9; // by rounding
  EXPECT_FALSE(FirstOverlap({ UnitCube, other }));
  other.lower.x = 0.99;
  const Box far{ glm::dvec3(5.0), glm::dvec3(6.0) };
  const std::pair<int, int> overlap(0, 2);
  EXPECT_EQ(FirstOverlap({ UnitCube, far, other }), overlap);
}
