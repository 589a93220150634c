#include "Core/Blocks/OwnerOrder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace varimarch;

namespace
{

constexpr Box CutCube{ glm::dvec3(0.0), glm::dvec3(1.0) };
const glm::dmat4 Unmoved(1.0);

struct OrderEye
{
  glm::dvec3 position;
  glm::dvec3 target;
  bool isParallel;
};

glm::dmat4 ClipFromWorld(const OrderEye& eye)
{
  const glm::dmat4 projection = eye.isParallel ? glm::ortho(-3.0, 3.0, -3.0, 3.0, 0.1, 100.0)
                                               : glm::perspective(1.0, 1.0, 0.1, 100.0);
  return projection * glm::lookAt(eye.position, eye.target, glm::dvec3(0.1, 0.2, 1.0));
}

Ray RayOfEye(const glm::dvec3& target, const OrderEye& eye)
{
  const glm::dvec3 direction = eye.isParallel ? eye.target - eye.position : target - eye.position;
  return { eye.isParallel ? target - 10.0 * direction : eye.position, direction };
}

// The distances at which a ray in the world enters and leaves a box.
Interval PassageThrough(const Ray& ray, const OwnedBox& box)
{
  const glm::dmat4 dataFromWorld = glm::inverse(box.worldFromData);
  return Intersection({ glm::dvec3(dataFromWorld * glm::dvec4(ray.origin, 1.0)),
                        glm::dvec3(dataFromWorld * glm::dvec4(ray.direction, 0.0)) },
    box.box);
}

// The parts of a cube that is cut at random places, each of an owner of its own. A cut goes through
// one part only, so that no parts hide each other in a circle.
std::vector<OwnedBox> CutAtRandom(int count, const glm::dmat4& worldFromData, std::mt19937& random)
{
  std::vector<Box> parts{ CutCube };
  std::uniform_real_distribution<double> fraction(0.2, 0.8);
  while (static_cast<int>(parts.size()) < count)
  {
    Box& cut = parts[random() % parts.size()];
    const int axis = static_cast<int>(random() % 3);
    const double place = glm::mix(cut.lower[axis], cut.upper[axis], fraction(random));
    Box upper = cut;
    upper.lower[axis] = place;
    cut.upper[axis] = place;
    parts.push_back(upper);
  }
  std::shuffle(parts.begin(), parts.end(), random);
  std::vector<OwnedBox> boxes;
  for (const Box& part : parts)
  {
    boxes.push_back({ part, worldFromData, static_cast<int>(boxes.size()) });
  }
  return boxes;
}

// True for a place in the picture of an eye.
bool IsSeen(const glm::dvec3& place, const OrderEye& eye)
{
  const glm::dvec4 clip = ClipFromWorld(eye) * glm::dvec4(place, 1.0);
  return std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
}

// The eight parts of a cube, one of each owner.
void AddOctants(const glm::dmat4& worldFromData, std::vector<OwnedBox>& boxes)
{
  for (int owner = 0; owner < 8; ++owner)
  {
    const glm::dvec3 lower(owner & 1, owner >> 1 & 1, owner >> 2);
    boxes.push_back({ { 0.5 * lower, 0.5 * lower + 0.5 }, worldFromData, owner });
  }
}

// The part of the rays into a view along which pictures of owners are laid over each other in a
// wrong order.
double WrongRays(const std::vector<OwnedBox>& boxes, const OwnerOrder& order, const OrderEye& eye)
{
  constexpr int Side = 40;
  int wrong = 0;
  for (int pixel = 0; pixel < Side * Side; ++pixel)
  {
    const glm::dvec3 target(2.2 * (pixel % Side) / Side, 0.0, 1.2 * (pixel / Side) / Side);
    double before = 0.0;
    bool isWrong = false;
    for (int owner : order.owners)
    {
      double own = before;
      for (const OwnedBox& box : boxes)
      {
        const Interval passage = PassageThrough(RayOfEye(target, eye), box);
        if (box.owner == owner && passage.exit - passage.enter > 1e-9)
        {
          isWrong = isWrong || passage.exit < before;
          own = std::max(own, passage.exit);
        }
      }
      before = own;
    }
    wrong += isWrong ? 1 : 0;
  }
  return double(wrong) / (Side * Side);
}

}

TEST(OwnerOrder, HasTurnedBoxesInTheOrderOfEachRay)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  int passages = 0;
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec3 axis(place(random), place(random), place(random) + 1.5);
    const glm::dmat4 worldFromData = glm::rotate(glm::dmat4(1.0), 3.0 * place(random), axis);
    const int count = 2 + i % 20;
    const std::vector<OwnedBox> boxes = CutAtRandom(count, worldFromData, random);
    const OrderEye eye{ 4.0 * glm::dvec3(place(random), place(random), place(random)),
      glm::dvec3(0.3, 0.2, 0.1), i % 2 == 0 };
    const OwnerOrder order = OwnersFrontToBack(boxes, count, ClipFromWorld(eye));
    EXPECT_FALSE(order.conflict);
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    ASSERT_TRUE(
      std::is_permutation(order.owners.begin(), order.owners.end(), all.begin(), all.end()));
    for (int j = 0; j < 50; ++j)
    {
      const glm::dvec3 target(
        worldFromData * glm::dvec4(0.5 + 0.5 * place(random), 0.5 + 0.5 * place(random), 0.5, 1.0));
      double before = -1e9;
      for (int owner : order.owners)
      {
        const Interval passage = PassageThrough(RayOfEye(target, eye), boxes[owner]);
        if (IsSeen(target, eye) && passage.exit - passage.enter > 1e-9 && passage.exit > 0.0)
        {
          EXPECT_GE(passage.exit, before);
          before = passage.exit;
          ++passages;
        }
      }
    }
  }
  EXPECT_GT(passages, 5000);
}

TEST(OwnerOrder, SaysThatBoxesOverlap)
{
  const Box other{ glm::dvec3(0.9, 0.0, 0.0), glm::dvec3(2.0, 1.0, 1.0) };
  const OrderEye eye{ { 0.5, -5.0, 0.5 }, { 0.5, 0.0, 0.5 }, false };
  const OwnerOrder order =
    OwnersFrontToBack({ { CutCube, Unmoved, 0 }, { other, Unmoved, 1 } }, 2, ClipFromWorld(eye));
  EXPECT_TRUE(order.conflict);
  EXPECT_EQ(order.owners.size(), 2u);
}

TEST(OwnerOrder, FindsPlanesBetweenTurnedBoxesWhoseBoundsOverlap)
{
  // Both are turned by 45 degrees, and touch along the diagonal.
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.785398163397448, glm::dvec3(0, 0, 1));
  const Box beside{ glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(2.0, 1.0, 1.0) };
  const std::vector<OwnedBox> boxes{ { CutCube, turned, 0 }, { beside, turned, 1 } };
  const OwnerOrder fromAbove =
    OwnersFrontToBack(boxes, 2, ClipFromWorld({ { 4.0, 5.0, 0.5 }, { 0.5, 1.0, 0.5 }, false }));
  EXPECT_FALSE(fromAbove.conflict);
  EXPECT_EQ(fromAbove.owners, (std::vector<int>{ 1, 0 }));
  const OwnerOrder fromBelow =
    OwnersFrontToBack(boxes, 2, ClipFromWorld({ { -4.0, -4.0, 0.5 }, { 0.5, 1.0, 0.5 }, true }));
  EXPECT_FALSE(fromBelow.conflict);
  EXPECT_EQ(fromBelow.owners, (std::vector<int>{ 0, 1 }));
}

TEST(OwnerOrder, FindsPlanesThatAreNoFace)
{
  // An edge of the upper cube crosses an edge of the lower one, a little above it.
  const Box cube{ glm::dvec3(-0.5), glm::dvec3(0.5) };
  const double eighth = glm::radians(45.0);
  const glm::dmat4 lower = glm::rotate(Unmoved, eighth, glm::dvec3(1.0, 0.0, 0.0));
  const glm::dmat4 upper = glm::rotate(
    glm::translate(Unmoved, glm::dvec3(0.0, 0.0, 1.45)), eighth, glm::dvec3(0.0, 1.0, 0.0));
  const OrderEye above{ { 0.5, 0.3, 6.0 }, { 0.0, 0.0, 0.7 }, false };
  const OwnerOrder order =
    OwnersFrontToBack({ { cube, lower, 0 }, { cube, upper, 1 } }, 2, ClipFromWorld(above));
  EXPECT_FALSE(order.conflict);
  EXPECT_EQ(order.owners, (std::vector<int>{ 1, 0 }));
}

TEST(OwnerOrder, FindsAFaceOfEitherBox)
{
  // A corner of one cube is in front of the middle of a face of the other.
  const Box cube{ glm::dvec3(-0.5), glm::dvec3(0.5) };
  const glm::dvec3 axis = glm::normalize(glm::cross(glm::dvec3(1.0), glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dmat4 onCorner = glm::rotate(
    glm::translate(Unmoved, glm::dvec3(0.0, 0.0, 1.4)), std::acos(std::sqrt(1.0 / 3.0)), axis);
  const OrderEye above{ { 0.5, 0.3, 6.0 }, { 0.0, 0.0, 0.7 }, true };
  const OwnedBox corner{ cube, onCorner, 1 };
  const OwnedBox face{ cube, Unmoved, 0 };
  for (const auto& boxes : { std::vector{ corner, face }, std::vector{ face, corner } })
  {
    const OwnerOrder order = OwnersFrontToBack(boxes, 2, ClipFromWorld(above));
    EXPECT_FALSE(order.conflict);
    EXPECT_EQ(order.owners, (std::vector<int>{ 1, 0 }));
  }
}

TEST(OwnerOrder, LetsFewPixelsBeWrongWhereOwnersHideEachOther)
{
  // Owner 0 hides all of a part of owner 1, which hides a little of owner 0.
  const Box front{ glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(1.0, 1.0, 1.0) };
  const Box behind{ glm::dvec3(0.0, 2.0, 0.0), glm::dvec3(1.0, 3.0, 1.0) };
  const Box small{ glm::dvec3(2.0, 0.0, 0.0), glm::dvec3(2.2, 0.2, 0.2) };
  const Box behindSmall{ glm::dvec3(2.0, 2.0, 0.0), glm::dvec3(2.2, 2.2, 0.2) };
  const std::vector<OwnedBox> boxes{ { behindSmall, Unmoved, 0 }, { front, Unmoved, 0 },
    { small, Unmoved, 1 }, { behind, Unmoved, 1 } };
  const OrderEye eye{ { 1.0, -5.0, 0.5 }, { 1.0, 0.0, 0.5 }, true };
  const OwnerOrder order = OwnersFrontToBack(boxes, 2, ClipFromWorld(eye));
  EXPECT_EQ(order.owners, (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(order.conflict, std::pair(0, 1));
}

TEST(OwnerOrder, LeavesOutWhatIsBehindTheEye)
{
  // Owners 0 and 1 hide each other behind the eye only.
  const Box front{ glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(1.0, 1.0, 1.0) };
  const Box behind{ glm::dvec3(0.0, 2.0, 0.0), glm::dvec3(1.0, 3.0, 1.0) };
  const Box nearer{ glm::dvec3(0.0, -12.0, 0.0), glm::dvec3(1.0, -11.0, 1.0) };
  const Box farther{ glm::dvec3(0.0, -14.0, 0.0), glm::dvec3(1.0, -13.0, 1.0) };
  const std::vector<OwnedBox> boxes{ { front, Unmoved, 0 }, { behind, Unmoved, 1 },
    { nearer, Unmoved, 1 }, { farther, Unmoved, 0 } };
  const OrderEye eye{ { 0.5, -5.0, 0.5 }, { 0.5, 0.0, 0.5 }, true };
  const OwnerOrder order = OwnersFrontToBack(boxes, 2, ClipFromWorld(eye));
  EXPECT_FALSE(order.conflict);
  EXPECT_EQ(order.owners, (std::vector<int>{ 0, 1 }));
}

TEST(OwnerOrder, OrdersTwoVolumesBesideEachOther)
{
  // Each of 8 processes has the same part of both volumes. The parts on the right of a volume are
  // in front of those on its left, but some on the left of the right volume are in front of those
  // on the right of the left one.
  std::vector<OwnedBox> boxes;
  AddOctants(Unmoved, boxes);
  AddOctants(glm::translate(Unmoved, glm::dvec3(1.125, 0.0, 0.0)), boxes);
  const OrderEye eye{ { 2.0, -3.25, 1.5 }, { 1.1, 0.5, 0.5 }, false };
  OwnerOrder order = OwnersFrontToBack(boxes, 8, ClipFromWorld(eye));
  EXPECT_TRUE(order.conflict);
  EXPECT_LT(WrongRays(boxes, order, eye), 0.01);
  order.owners = { 1, 3, 5, 7, 0, 2, 4, 6 }; // as if the volumes were one
  EXPECT_GT(WrongRays(boxes, order, eye), 0.05) << "nothing to be wrong";
}
