#ifndef Varimarch_Benchmarks_OrderFit_h
#define Varimarch_Benchmarks_OrderFit_h

#include <optional>
#include <vector>

namespace varimarch
{

/// The error at one refinement.
struct OrderPoint
{
  double width;   ///< width of a step, a cell or a pixel, or a tolerance, > 0
  double rmse;    ///< [1/255]
  double largest; ///< largest error of a channel [1/255]
};

/// The order p of errors that are c * width^p.
struct OrderFit
{
  double order;
  double halfWidth; ///< half the width of the 95 % confidence interval of the order
  int points;       ///< number of points that it is fitted to
};

/// Fits a straight line to the logarithms of width and RMSE by least squares.
/// @param floor  smaller errors are left out, because rounding dominates them [1/255]
/// @return empty for fewer than three points
std::optional<OrderFit> FitOrder(const std::vector<OrderPoint>& points, double floor);

}

#endif
