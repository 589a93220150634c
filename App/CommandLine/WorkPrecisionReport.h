#ifndef Varimarch_CommandLine_WorkPrecisionReport_h
#define Varimarch_CommandLine_WorkPrecisionReport_h

#include "Machine.h"
#include "Scene/LogLogPlot.h"
#include "WorkPrecision.h"

#include <nlohmann/json.hpp>

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

/// Columns in line, for a terminal: those rows of all scenes.
std::string TableText(const std::vector<WorkPrecision>& scenes);

/// A heading, and a line per scene, method and setting.
std::string TableCsv(const std::vector<WorkPrecision>& scenes);

/// All that was measured.
nlohmann::ordered_json ToJson(const WorkPrecision& scene);

}

#endif
