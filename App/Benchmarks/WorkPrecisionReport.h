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

// Reports of work-precision measurements as text, CSV, JSON and plots. Errors are in 1/255 of
// premultiplied RGBA before the background.

/// Plots the error over the median time.
LogLogPlot TimePlot(const WorkPrecision& scene);

/// Plots the error over the mean number of fetches per pixel, which does not depend on the machine.
LogLogPlot FetchPlot(const WorkPrecision& scene);

/// Our time at the error of one of VTK's settings.
struct EqualErrorRow
{
  double voxels; ///< VTK's sample distance, in smallest voxel spacings
  double rmse;
  double vtkMs;
  std::optional<double> oursMs; ///< our time; empty if no setting has so small an error
};

/// A row for each setting of VTK's GPU mapper; none if it or our defaults were not measured.
std::vector<EqualErrorRow> EqualErrorRows(const WorkPrecision& scene);

/// The methods that use our mapper as intended.
const std::vector<std::string>& OurMethods();

/// The smallest speed-up over VTK's GPU mapper, and the error at which it occurs.
struct WorstRatio
{
  double rmse;
  std::optional<double> times; ///< speed-up; empty if no setting has so small an error
};

/// Searches all RMSE from VTK's GPU mapper's largest to its smallest for the smallest speed-up of
/// the fastest method. Empty if VTK's mapper or all of the methods were not measured.
std::optional<WorstRatio> WorstAgainstVtk(
  const WorkPrecision& scene, const std::vector<std::string>& methods);

/// The smallest and the largest RMSE of a curve.
std::array<double, 2> ErrorsOf(const WorkCurve& curve);

/// The file name of a scene's time plot, without folder and extension.
std::string PlotStem(const WorkPrecision& scene);

/// The EqualErrorRows of all scenes in aligned columns, for a terminal.
std::string TableText(const std::vector<WorkPrecision>& scenes);

/// A CSV table with a header line, and a line per scene, method and setting.
std::string TableCsv(const std::vector<WorkPrecision>& scenes);

/// All measurements of a scene as JSON.
nlohmann::ordered_json ToJson(const WorkPrecision& scene);

}

#endif
