// Edits of a look keep the curves valid, and change only what they were asked to.

#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace varimarch;

namespace
{

constexpr double Ramp = 10.0;

constexpr NodeId Point(int index)
{
  return { NodeKind::Opacity, index };
}

constexpr NodeId Stop(int index)
{
  return { NodeKind::Color, index };
}

// Points at 0, 200 and, as a step, 100; a colour at 0, two at the step, and an untied one at 150.
Look SteppedLook()
{
  Look look;
  look.opacities = { { 0.0, 0.0 }, { 100.0, 0.2 }, { 100.0, 0.6 }, { 200.0, 1.0 } };
  look.colors = { { 0.0, { 0.0, 0.0, 0.0 } }, { 100.0, { 1.0, 0.0, 0.0 } },
    { 100.0, { 0.0, 1.0, 0.0 } }, { 150.0, { 0.0, 0.0, 1.0 } } };
  return look;
}

void ExpectCurves(const Look& look)
{
  const auto below = [](const auto& a, const auto& b) { return a.value < b.value; };
  EXPECT_TRUE(std::is_sorted(look.opacities.begin(), look.opacities.end(), below));
  EXPECT_TRUE(std::is_sorted(look.colors.begin(), look.colors.end(), below));
  EXPECT_FALSE(look.opacities.empty());
  EXPECT_FALSE(look.colors.empty());
  for (const OpacityNode& node : look.opacities)
  {
    EXPECT_GE(node.opacity, 0.0);
    EXPECT_LE(node.opacity, 1.0);
  }
}

}

TEST(LookEditing, AnInsertedPointKeepsTheColorOfItsValue)
{
  const Look look = SteppedLook();
  const Insertion added = InsertPoint(look, 50.0, 0.9, Ramp);
  EXPECT_EQ(added.node, Point(1));
  EXPECT_EQ(added.look.opacities[1].opacity, 0.9);
  ASSERT_EQ(added.look.colors.size(), look.colors.size() + 1);
  for (double value = -50.0; value <= 250.0; value += 5.0)
  {
    const glm::dvec3 change = FunctionOf(added.look).Color(value) - FunctionOf(look).Color(value);
    EXPECT_LT(glm::dot(change, change), 1e-20) << "at " << value;
  }
}

// Without it, everything below the new point would be as opaque as the point.
TEST(LookEditing, APointBeyondADarkEndComesWithADarkOne)
{
  Look look = SteppedLook();
  look.opacities.push_back({ 300.0, 0.0 });
  const Insertion below = InsertPoint(look, -50.0, 0.5, Ramp);
  EXPECT_EQ(below.node, Point(1));
  EXPECT_EQ(below.look.opacities[0].value, -60.0);
  for (const double dark : { -1000.0, -60.0, 301.0, 5000.0 })
  {
    EXPECT_EQ(FunctionOf(below.look).Opacity(dark), 0.0) << dark;
  }
  EXPECT_EQ(FunctionOf(below.look).Opacity(-50.0), 0.5);
  const Insertion above = InsertPoint(look, 304.0, 0.5, Ramp);
  EXPECT_EQ(above.node, Point(5));
  EXPECT_EQ(above.look.opacities.back().value, 308.0) << "no farther than the distance of the end";
  EXPECT_EQ(FunctionOf(above.look).Opacity(5000.0), 0.0);
}

TEST(LookEditing, APointThatIsNotBeyondADarkEndComesAlone)
{
  const Look look = SteppedLook(); // opaque above its last point
  EXPECT_EQ(InsertPoint(look, 250.0, 0.5, Ramp).look.opacities.size(), 5u);
  EXPECT_EQ(InsertPoint(look, -50.0, 0.0, Ramp).look.opacities.size(), 5u);
  EXPECT_EQ(InsertPoint(look, 50.0, 0.9, Ramp).look.opacities.size(), 5u);
}

TEST(LookEditing, IsosurfacesAreTheNodes)
{
  Look look = WithSurface(SteppedLook());
  look.blend = Blend::Isosurface;
  ASSERT_EQ(AllNodes(look), (NodeSet{ { NodeKind::Surface, 0 } }));
  EXPECT_EQ(look.isosurfaces[0].value, 100.0) << "at half of the largest opacity";
  const Insertion added = InsertPoint(look, 50.0, 0.25, Ramp);
  EXPECT_EQ(added.node, (NodeId{ NodeKind::Surface, 0 }));
  ASSERT_EQ(added.look.isosurfaces.size(), 2u);
  EXPECT_EQ(added.look.isosurfaces[0].rgb, glm::dvec3(0.5, 0.0, 0.0));
  const Look moved = MoveNodes(added.look, { added.node }, 70.0, 0.5);
  EXPECT_EQ(moved.isosurfaces[0].value, 100.0) << "stops at its neighbour";
  EXPECT_EQ(moved.isosurfaces[0].opacity, 0.75);
  EXPECT_EQ(SetColor(moved, added.node, { 0.0, 0.0, 1.0 }).isosurfaces[0].rgb.b, 1.0);
  EXPECT_EQ(RemoveNodes(moved, AllNodes(moved), Ramp).isosurfaces.size(), 1u) << "one stays";
  EXPECT_EQ(moved.opacities.size(), look.opacities.size());
}

TEST(LookEditing, ACurveWithoutColoursGetsNone)
{
  Look curve;
  curve.opacities = { { 0.0, 0.0 }, { 10.0, 1.0 } };
  const Insertion added = InsertPoint(curve, 5.0, 0.25, Ramp);
  EXPECT_EQ(added.look.opacities.size(), 3u);
  EXPECT_TRUE(added.look.colors.empty());
}

TEST(LookEditing, APointAtAColorStopIsTiedToIt)
{
  const Insertion added = InsertPoint(SteppedLook(), 150.0, 0.5, Ramp);
  EXPECT_EQ(added.look.colors.size(), SteppedLook().colors.size());
  EXPECT_EQ(WithTied(added.look, { added.node }), (NodeSet{ added.node, Stop(3) }));
}

TEST(LookEditing, AnInsertedColorKeepsStepsBetweenNodes)
{
  Look look = SteppedLook();
  look.colors = { { 0.0, { 0.0, 0.0, 0.0 }, { 0.3, 1.0 } }, { 100.0, { 1.0, 1.0, 1.0 } } };
  for (const double inserted : { 10.0, 60.0 })
  {
    const Look changed = InsertColor(look, inserted).look;
    for (const double value : { 5.0, 20.0, 29.9, 30.1, 45.0, 70.0, 95.0 })
    {
      EXPECT_EQ(FunctionOf(changed).Color(value).r, value < 30.0 ? 0.0 : 1.0) << "at " << value;
    }
  }
}

TEST(LookEditing, PointsStopAtTheirNeighboursAndColorsAtTheirs)
{
  const Look look = SteppedLook();
  EXPECT_EQ(MoveNodes(look, { Point(0) }, 500.0, 0.0).opacities[0].value, 100.0);
  EXPECT_EQ(MoveNodes(look, { Point(3) }, -500.0, 0.0).opacities[3].value, 100.0);
  // Its colour is stopped by the one at 150.
  EXPECT_EQ(MoveNodes(look, { Point(2) }, 500.0, 0.0).opacities[2].value, 150.0);
  EXPECT_EQ(MoveNodes(look, { Point(3) }, 0.0, 3.0).opacities[3].opacity, 1.0);
  EXPECT_EQ(MoveNodes(look, { Point(3) }, 0.0, -3.0).opacities[3].opacity, 0.0);
}

TEST(LookEditing, TiedColorsMoveWithTheirPointsAndPointsWithTheirColors)
{
  const Look look = SteppedLook();
  for (const NodeSet& moved : { NodeSet{ Point(0) }, NodeSet{ Stop(0) } })
  {
    const Look changed = MoveNodes(look, moved, 30.0, 0.0);
    EXPECT_EQ(changed.opacities[0].value, 30.0);
    EXPECT_EQ(changed.colors[0].value, 30.0);
    EXPECT_EQ(changed.opacities[1].value, 100.0);
  }
  // Each side of a step has its own tied colour.
  EXPECT_EQ(WithTied(look, { Point(1) }), (NodeSet{ Point(1), Stop(1) }));
  EXPECT_EQ(WithTied(look, { Point(2) }), (NodeSet{ Point(2), Stop(2) }));
  EXPECT_EQ(WithTied(look, { Stop(3) }), (NodeSet{ Stop(3) }));
}

TEST(LookEditing, SelectedPointsMoveAsOne)
{
  const Look look = SteppedLook();
  const Look changed = MoveNodes(look, { Point(1), Point(2) }, 500.0, 0.1);
  EXPECT_EQ(changed.opacities[1].value, 150.0);
  EXPECT_EQ(changed.opacities[2].value, 150.0);
  EXPECT_DOUBLE_EQ(changed.opacities[1].opacity, 0.3);
  EXPECT_DOUBLE_EQ(changed.opacities[2].opacity, 0.7);
  EXPECT_EQ(changed.opacities[0].value, 0.0);
}

TEST(LookEditing, AValueThatWasTypedIsTakenExactly)
{
  const Look changed = SetValue(SteppedLook(), Point(2), 100.0 + 1.0 / 3.0);
  EXPECT_EQ(changed.opacities[2].value, 100.0 + 1.0 / 3.0);
  EXPECT_EQ(changed.colors[2].value, 100.0 + 1.0 / 3.0);
  EXPECT_EQ(SetValue(SteppedLook(), Point(0), 900.0).opacities[0].value, 100.0);
}

TEST(LookEditing, ADeletedPointRemovesItsColorAndADeletedColorNoPoint)
{
  const Look withoutPoint = RemoveNodes(SteppedLook(), { Point(1) }, Ramp);
  EXPECT_EQ(withoutPoint.opacities.size(), 3u);
  ASSERT_EQ(withoutPoint.colors.size(), 3u);
  EXPECT_EQ(withoutPoint.colors[1].rgb, glm::dvec3(0.0, 1.0, 0.0));
  const Look withoutColor = RemoveNodes(SteppedLook(), { Stop(1) }, Ramp);
  EXPECT_EQ(withoutColor.opacities.size(), 4u);
  EXPECT_EQ(withoutColor.colors.size(), 3u);
}

// Without its last transparent point, a curve would stay opaque beyond its end.
TEST(LookEditing, RemovingADarkEndKeepsTheOutsideDark)
{
  Look look = SteppedLook();
  look.opacities.push_back({ 300.0, 0.0 });
  const NodeSet ends[] = { { Point(0) }, { Point(4) }, { Point(0), Point(4) },
    { Point(0), Point(1), Point(2), Point(4) } };
  for (const NodeSet& removed : ends)
  {
    const Look changed = RemoveNodes(look, removed, Ramp);
    ExpectCurves(changed);
    for (const double dark : { -1000.0, 0.0, 300.0, 5000.0 })
    {
      EXPECT_EQ(FunctionOf(changed).Opacity(dark), 0.0) << dark;
    }
    EXPECT_EQ(FunctionOf(changed).Opacity(200.0), 1.0);
  }
  EXPECT_EQ(RemoveNodes(look, { Point(4) }, Ramp).opacities.back().value, 210.0);
  EXPECT_EQ(RemoveNodes(look, { Point(3) }, Ramp).opacities.size(), 4u) << "the end stays";
  EXPECT_EQ(RemoveNodes(SteppedLook(), { Point(3) }, Ramp).opacities.size(), 3u) << "it was lit";
}

TEST(LookEditing, EachCurveKeepsANode)
{
  const Look changed = RemoveNodes(SteppedLook(), AllNodes(SteppedLook()), Ramp);
  EXPECT_EQ(changed.opacities.size(), 1u);
  EXPECT_EQ(changed.colors.size(), 1u);
}

TEST(LookEditing, APointWithoutAColorGetsOneAndOthersKeepTheirs)
{
  const glm::dvec3 blue(0.0, 0.0, 1.0);
  const Look ofTied = SetColor(SteppedLook(), Point(1), blue);
  EXPECT_EQ(ofTied.colors.size(), 4u);
  EXPECT_EQ(ofTied.colors[1].rgb, blue);
  EXPECT_EQ(ofTied.colors[2].rgb, glm::dvec3(0.0, 1.0, 0.0));
  const Look ofLone = SetColor(SteppedLook(), Point(3), blue);
  ASSERT_EQ(ofLone.colors.size(), 5u);
  EXPECT_EQ(ofLone.colors[4].value, 200.0);
  EXPECT_EQ(ofLone.colors[4].rgb, blue);
}

TEST(LookEditing, AScaledCurveIsTheSameCurveElsewhere)
{
  const Look look = SteppedLook();
  const Look scaled = ScaleLook(look, 3.0, 50.0);
  for (double value = -20.0; value <= 220.0; value += 7.0)
  {
    const double there = 50.0 + 3.0 * (value - 50.0);
    EXPECT_NEAR(FunctionOf(scaled).Opacity(there), FunctionOf(look).Opacity(value), 1e-12);
  }
  EXPECT_EQ(scaled.opacities[1].value, scaled.opacities[2].value);
}

TEST(LookEditing, AnyMovesOfAnyNodesKeepCurvesStepsAndTies)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-150.0, 150.0);
  Look look = SteppedLook();
  for (int i = 0; i < 2000; ++i)
  {
    NodeSet moved;
    for (const NodeId& node : AllNodes(look))
    {
      if (random() % 3 == 0)
      {
        moved.insert(node);
      }
    }
    const NodeSet together = WithTied(look, moved);
    const Look changed = MoveNodes(look, moved, shift(random), shift(random) / 150.0);
    ExpectCurves(changed);
    // Nodes that shared a value and moved, or stayed, together still share one.
    for (const NodeId& a : AllNodes(look))
    {
      for (const NodeId& b : AllNodes(look))
      {
        if (ValueOf(look, a) == ValueOf(look, b) && together.count(a) == together.count(b))
        {
          EXPECT_EQ(ValueOf(changed, a), ValueOf(changed, b));
        }
      }
    }
    look = changed;
  }
}
