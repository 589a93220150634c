#include "OpacityCurve.h"
#include "ReferenceVolumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

TEST(TransferFunction, RunsLinearlyBetweenNodesAndStaysConstantBeyond)
{
  const TransferFunction function({ { 0.0, { 1.0, 0.0, 0.0 } }, { 10.0, { 0.0, 0.5, 1.0 } } },
    { { 2.0, 0.2 }, { 4.0, 0.6 } }, 1.0);
  EXPECT_DOUBLE_EQ(function.Opacity(3.0), 0.4);
  EXPECT_DOUBLE_EQ(function.Opacity(-100.0), 0.2);
  EXPECT_DOUBLE_EQ(function.Opacity(100.0), 0.6);
  EXPECT_DOUBLE_EQ(function.Color(5.0).g, 0.25);
  EXPECT_EQ(function.Color(-1.0), glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(function.Color(11.0), glm::dvec3(0.0, 0.5, 1.0));
}

TEST(TransferFunction, WithoutNodesIsWhiteAndClear)
{
  const TransferFunction function({}, {}, 1.0);
  EXPECT_EQ(function.Color(3.0), glm::dvec3(1.0));
  EXPECT_EQ(function.Extinction(3.0), 0.0);
  EXPECT_EQ(function.FirstValue(), 0.0);
  EXPECT_EQ(function.LastValue(), 0.0);
}

TEST(TransferFunction, NotANumberIsClear)
{
  const TransferFunction function = OpacityCurve({ { 0.0, 0.5 } });
  EXPECT_EQ(function.Opacity(std::nan("")), 0.0);
  EXPECT_EQ(function.Extinction(std::nan("")), 0.0);
}

TEST(TransferFunction, EqualNodesAreExactBetween)
{
  const TransferFunction function =
    OpacityCurve({ { 0.1, 1.0 }, { 0.7, 1.0, { 0.3, 0.4 } }, { 3.3, 1.0 } });
  for (double value = 0.0; value < 3.3; value += 0.0137)
  {
    ASSERT_EQ(function.Opacity(value), 1.0);
    ASSERT_EQ(function.Extinction(value), infinity);
  }
}

TEST(TransferFunction, MidpointIsWhereTheCurveReachesHalfWay)
{
  for (const double sharpness : { 0.0, 0.3, 0.8 })
  {
    const TransferFunction function =
      OpacityCurve({ { 0.0, 0.2, { 0.25, sharpness } }, { 8.0, 1.0 } });
    EXPECT_DOUBLE_EQ(function.Opacity(2.0), 0.6);
    EXPECT_NEAR(function.Opacity(1e-12), 0.2, 1e-9);
    EXPECT_NEAR(function.Opacity(8.0 - 1e-12), 1.0, 1e-9);
  }
}

TEST(TransferFunction, SharpnessFollowsTheCurveOfVtk)
{
  // Sharpness 0.5, a quarter of the way: s = 0.5 * 0.5^6, then the Hermite cubic.
  const double s = 0.5 / 64.0;
  const double h2 = 3.0 * s * s - 2.0 * s * s * s;
  const double h3 = s * s * s - 2.0 * s * s + s;
  const double h4 = s * s * s - s * s;
  const double expected = h2 + 0.5 * (h3 + h4);
  const TransferFunction function = OpacityCurve({ { 0.0, 0.0, { 0.5, 0.5 } }, { 4.0, 1.0 } });
  EXPECT_NEAR(function.Opacity(1.0), expected, 1e-15);
  EXPECT_NEAR(function.Opacity(3.0), 1.0 - expected, 1e-15);
}

TEST(TransferFunction, FullSharpnessIsAStepAtTheMidpoint)
{
  const TransferFunction function = OpacityCurve({ { 0.0, 0.1, { 0.75, 1.0 } }, { 4.0, 0.9 } });
  EXPECT_DOUBLE_EQ(function.Opacity(2.999), 0.1);
  EXPECT_DOUBLE_EQ(function.Opacity(3.0), 0.9);
}

TEST(TransferFunction, StepAtTheMidpointIsExactlyAtTheHalfWayValue)
{
  for (double left = -1.0; left < 0.0; left += 0.0137)
  {
    const NodeShape step{ 0.6, 1.0 };
    const TransferFunction function = OpacityCurve({ { left, 0.1, step }, { 1.1, 0.9 } });
    const double there = HalfWayValue(left, 1.1, step);
    ASSERT_EQ(function.Opacity(std::nextafter(there, left)), 0.1);
    ASSERT_EQ(function.Opacity(there), 0.9);
  }
}

TEST(TransferFunction, TwoNodesAtOneValueStepBehindIt)
{
  const TransferFunction function =
    OpacityCurve({ { 0.0, 0.0 }, { 5.0, 0.0 }, { 5.0, 0.7 }, { 9.0, 0.7 } });
  EXPECT_EQ(function.Opacity(5.0), 0.0);
  EXPECT_EQ(function.Opacity(std::nextafter(5.0, 9.0)), 0.7);
  EXPECT_EQ(function.SmallestNodeGap(), 4.0);
}

TEST(TransferFunction, ExtinctionGivesBackTheOpacityOverTheUnitDistance)
{
  for (const double opacity : { 1e-15, 1e-8, 0.3, 0.999 })
  {
    const double extinction = OpacityCurve({ { 0.0, opacity } }, 2.5).Extinction(0.0);
    EXPECT_NEAR(-std::expm1(-extinction * 2.5) / opacity, 1.0, 1e-14);
  }
}

TEST(TransferFunction, OpaqueHasInfiniteExtinctionAndOneUlpBelowHasNot)
{
  EXPECT_EQ(OpacityCurve({ { 0.0, 1.0 } }).Extinction(0.0), infinity);
  const double almost = std::nextafter(1.0, 0.0);
  EXPECT_NEAR(OpacityCurve({ { 0.0, almost } }).Extinction(0.0), 53.0 * std::log(2.0), 1e-12);
}

TEST(TransferFunction, ExtinctionIsAccurateJustBesideAnOpaqueNode)
{
  const TransferFunction ramp = OpacityCurve({ { 0.0, 0.0 }, { 4.0, 1.0 }, { 6.0, 0.5 } });
  EXPECT_NEAR(ramp.Extinction(std::nextafter(4.0, 0.0)), 53.0 * std::log(2.0), 1e-12);
  EXPECT_NEAR(ramp.Extinction(std::nextafter(4.0, 6.0)), 52.0 * std::log(2.0), 1e-12);
  EXPECT_EQ(ramp.Extinction(4.0), infinity);

  // A curve that sharpness presses against its node: 1 - opacity is about 3e-19.
  const TransferFunction sharp = OpacityCurve({ { 0.0, 0.0, { 0.5, 0.98 } }, { 4.0, 1.0 } });
  const double s = 0.5 * std::pow(0.03, 10.8);
  const double transparency = 0.02 * s + s * s * (3.0 - 2.0 * s) - 0.02 * s * s * (3.0 - 2.0 * s);
  EXPECT_NEAR(sharp.Extinction(4.0 - 0.06), -std::log(transparency), 1e-9);
}

TEST(TransferFunction, BadNodesAreRefused)
{
  EXPECT_THROW(OpacityCurve({ { 1.0, 0.5 }, { 0.0, 0.5 } }), std::invalid_argument);
  EXPECT_THROW(OpacityCurve({ { infinity, 0.5 } }), std::invalid_argument);
  EXPECT_THROW(OpacityCurve({ { 0.0, std::nan("") } }), std::invalid_argument);
  EXPECT_THROW(OpacityCurve({ { 0.0, 0.5 } }, 0.0), std::invalid_argument);
  EXPECT_THROW(OpacityCurve({ { 0.0, 0.5 } }, infinity), std::invalid_argument);
  EXPECT_THROW(TransferFunction({ { 0.0, glm::dvec3(infinity) } }, {}, 1.0), std::invalid_argument);
}

TEST(TransferFunction, NodesWithNoNumberBetweenThemMakeAStepWhoseValueIsRight)
{
  const double below = std::nextafter(7.0, 0.0);
  const TransferFunction function = OpacityCurve({ { below, 0.2 }, { 7.0, 0.6 }, { 9.0, 0.6 } });
  EXPECT_EQ(function.Opacity(below), 0.2);
  EXPECT_EQ(function.Opacity(7.0), 0.6);
  ASSERT_EQ(function.Steps().size(), 1u);
  EXPECT_EQ(function.Steps().front().value, 7.0);
  EXPECT_FALSE(function.Steps().front().valueIsLeft);
  EXPECT_TRUE(function.HasStepAt(7.0));
  EXPECT_FALSE(function.IsPiecewiseLinear());
  EXPECT_EQ(function.SmallestNodeGap(), 2.0);
}

TEST(TransferFunction, KnowsWhetherItIsPiecewiseLinear)
{
  const std::vector<ColorNode> colors = { { 0.0, glm::dvec3(0.0) }, { 10.0, glm::dvec3(1.0) } };
  const auto isLinear = [&](std::vector<OpacityNode> opacities)
  { return TransferFunction(colors, std::move(opacities), 1.0).IsPiecewiseLinear(); };
  EXPECT_TRUE(isLinear({ { 0.0, 0.0 }, { 4.0, 0.5 }, { 10.0, 0.0 } }));
  EXPECT_FALSE(isLinear({ { 0.0, 0.0, { 0.3, 0.0 } }, { 10.0, 0.5 } }));
  EXPECT_FALSE(isLinear({ { 0.0, 0.0, { 0.5, 0.2 } }, { 10.0, 0.5 } }));
  EXPECT_FALSE(isLinear({ { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 0.5 } })) << "it jumps";
  EXPECT_TRUE(isLinear({ { 0.0, 0.0 }, { 10.0, 0.5, { 0.9, 0.9 } } })) << "nothing follows";
}
