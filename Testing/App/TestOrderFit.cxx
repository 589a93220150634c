#include "Benchmarks/OrderFit.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

std::vector<OrderPoint> ErrorsOfOrder(double order, double disturbance)
{
  std::vector<OrderPoint> points;
  for (int i = 0; i < 6; ++i)
  {
    const double width = std::pow(0.5, i);
    const double factor = i % 2 ? 1.0 + disturbance : 1.0 - disturbance;
    points.push_back({ width, 3.0 * factor * std::pow(width, order), 0.0 });
  }
  return points;
}

}

TEST(OrderFit, FindsTheOrderOfExactErrors)
{
  for (const double order : { 1.0, 2.0, 4.0 })
  {
    const auto fit = FitOrder(ErrorsOfOrder(order, 0.0), 0.0);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->order, order, 1e-9);
    EXPECT_NEAR(fit->halfWidth, 0.0, 1e-6);
    EXPECT_EQ(fit->points, 6);
  }
}

TEST(OrderFit, IsAsWideAsTheErrorsScatter)
{
  const auto calm = FitOrder(ErrorsOfOrder(2.0, 0.05), 0.0);
  const auto rough = FitOrder(ErrorsOfOrder(2.0, 0.5), 0.0);
  ASSERT_TRUE(calm && rough);
  EXPECT_LT(std::abs(calm->order - 2.0), calm->halfWidth);
  EXPECT_LT(std::abs(rough->order - 2.0), rough->halfWidth);
  EXPECT_GT(rough->halfWidth, 5.0 * calm->halfWidth);
}

// Student's t for one degree of freedom is 12.706; residuals and abscissae are simple numbers.
TEST(OrderFit, HasTheConfidenceOfStudentsDistribution)
{
  const double e = std::exp(1.0);
  const auto fit = FitOrder({ { 1.0, 1.0, 0.0 }, { e, e * e, 0.0 }, { e * e, e * e, 0.0 } }, 0.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 1.0, 1e-9);
  // Residuals -1/3, 2/3, -1/3: their squares sum to 2/3, and those of the abscissae to 2.
  EXPECT_NEAR(fit->halfWidth, 12.706 * std::sqrt(2.0 / 3.0 / 2.0), 1e-3);
}

TEST(OrderFit, LeavesOutWhatRoundingDominates)
{
  std::vector<OrderPoint> points = ErrorsOfOrder(2.0, 0.0);
  points.push_back({ 1e-3, 0.01, 0.0 });
  const auto fit = FitOrder(points, 0.02);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->points, 4);
  EXPECT_NEAR(fit->order, 2.0, 1e-9);
  EXPECT_FALSE(FitOrder({ points[0], points[1], points.back() }, 0.02));
}
