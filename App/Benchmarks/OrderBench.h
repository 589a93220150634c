#ifndef Varimarch_Benchmarks_OrderBench_h
#define Varimarch_Benchmarks_OrderBench_h

#include "CommandLine/Truth.h"
#include "LogLogPlot.h"
#include "OrderFit.h"
#include "Scene/Scene.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The errors of one method under refinement.
struct OrderCurve
{
  std::string method;
  CurveStyle style;
  std::optional<double> expected; ///< order by theory; empty: no theory
  std::vector<OrderPoint> points; ///< points, coarsest first
  std::optional<OrderFit> fit;
};

/// The errors of all methods under one kind of refinement of a scene.
struct OrderExperiment
{
  std::string name;      ///< name, usable as a file name
  std::string title;     ///< title, with what is refined and the scene
  std::string widthName; ///< the refined width, with its unit
  std::vector<OrderCurve> curves;
  /// Widths above this are not in the range in which the error has an order.
  double widestFitted = std::numeric_limits<double>::infinity();
};

/// Errors below this are left out of fits: those of sums of floats [1/255].
constexpr double OrderFloor = 0.0005;

/// Measures the observed orders of convergence, after Etiene et al., "Verifying volume rendering
/// using discretization error analysis", TVCG 20(1), 2014, and Etiene, Kirby, Silva, "A study of
/// discretization errors in volume rendering integral approximations", Eurographics short papers,
/// 2013: under refinement of the steps, of the tolerance, of the grid and of the pixels. The
/// volumes of the first two are the ramp and the checkerboard of ProceduralVolume.h.
/// @param side     height and width of the images [pixels]; pixels are refined from an eighth of it
/// @param onResult receives all finished experiments after each of them
void MeasureOrders(int side, const OnStep& onStep,
  const std::function<void(const std::vector<OrderExperiment>&)>& onResult);

}

#endif
