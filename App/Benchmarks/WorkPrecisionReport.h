#ifndef Varimarch_Benchmarks_WorkPrecisionReport_h
#define Varimarch_Benchmarks_WorkPrecisionReport_h

#include "LogLogPlot.h"
#include "Machine.h"
#include "WorkPrecision.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// Work-precision measurements in the forms people and programs read. Errors are in 1/255 of
/// premultiplied RGBA before the background.

/// Error over median time.
LogLogPlot TimePlot(const WorkPrecision& scene);

/// Error over mean readings of the volume for a pixel: what does not depend on the machine.
LogLogPlot FetchPlot(const WorkPrecision& scene);

/// What our default takes where VTK's GPU mapper errs as much.
struct EqualErrorRow
{
  double voxels; ///< VTK's sample distance, in smallest distances of voxels
  double rmse;
  double vtkMs;
  std::optional<double> oursMs; ///< empty: none of our settings errs so little
};

/// A row for each setting of VTK's GPU mapper; none when one of both was not measured.
std::vector<EqualErrorRow> EqualErrorRows(const WorkPrecision& scene);

/// The methods that are our mapper as it is meant to be used.
const std::vector<std::string>& OurMethods();

/// Where methods are the least faster than VTK's GPU mapper.
struct WorstRatio
{
  double rmse;
  std::optional<double> times; ///< as fast; empty: none of their settings errs so little
};

/// Of all RMSE that VTK's GPU mapper reaches, from its largest to its smallest; at each the fastest
/// of the methods counts. Empty when it, or all of them, were not measured.
std::optional<WorstRatio> WorstAgainstVtk(
  const WorkPrecision& scene, const std::vector<std::string>& methods);

/// The smallest and the largest RMSE of a curve.
std::array<double, 2> ErrorsOf(const WorkCurve& curve);

/// The file of a scene's plot over time, without folder and extension.
std::string PlotStem(const WorkPrecision& scene);

/// Columns in line, for a terminal: those rows of all scenes.
std::string TableText(const std::vector<WorkPrecision>& scenes);

/// A heading, and a line per scene, method and setting.
std::string TableCsv(const std::vector<WorkPrecision>& scenes);

/// All that was measured.
nlohmann::ordered_json ToJson(const WorkPrecision& scene);

}

#endif
