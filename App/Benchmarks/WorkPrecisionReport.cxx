#include "WorkPrecisionReport.h"

#include "CommandLine/Results.h"
#include "Scene/SceneNames.h"
#include "ToleranceReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace varimarch
{

namespace
{

std::string OrNothing(const std::optional<double>& number)
{
  return number ? Fixed(*number, 5) : "";
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene, const WorkPoint& point)
{
  nlohmann::ordered_json json = { { "setting", point.setting.label },
    { "voxels", VoxelsOf(scene, point) }, { "sampleDistanceMm", point.sampleDistanceMm } };
  if (const auto tolerance = ToleranceOf(point))
  {
    json["errorTolerance"] = *tolerance;
    json["estimatedError"] = point.estimatedError;
  }
  json.update(ToJson(point.error));
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
  }
  if (point.graphicsBytes)
  {
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  json["roundsMs"] = point.roundsMs;
  json["medianMs"] = point.medianMs;
  return json;
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene, const WorkCurve& curve)
{
  nlohmann::ordered_json json = { { "method", curve.method.name }, { "title", curve.method.title },
    { "renderer", NameOf(MapperKindNames(), curve.method.kind) }, { "eightBits", curve.eightBits },
    { "skipped", curve.skipped } };
  for (const WorkPoint& point : curve.points)
  {
    json["points"].push_back(ToJson(scene, point));
  }
  if (curve.orbit)
  {
    json["orbit"] = { { "setting", curve.points[curve.shown].setting.label },
      { "frames", curve.orbit->frames }, { "degreesPerFrame", curve.orbit->degreesPerFrame },
      { "medianChange255", curve.orbit->median }, { "largestChange255", curve.orbit->largest },
      { "largestAtDegrees", curve.orbit->largestAtDegrees } };
  }
  return json;
}

// Plots the error over `workOf` of each point. Points for which it is empty are left out.
template <class WorkOf>
LogLogPlot ErrorPlot(const WorkPrecision& scene, const std::string& xTitle, const WorkOf& workOf)
{
  LogLogPlot plot = { scene.name, xTitle, "RMSE of premultiplied RGBA [1/255]", {}, {} };
  bool eightBits = false;
  for (const WorkCurve& curve : scene.curves)
  {
    PlotCurve line = { curve.method.title, curve.method.style, {} };
    for (const WorkPoint& point : curve.points)
    {
      const double error = point.error.light.rootMeanSquare;
      const std::optional<double> work = workOf(point);
      if (error > 0.0 && std::isfinite(error) && work.value_or(0.0) > 0.0)
      {
        line.points.push_back({ *work, error });
      }
    }
    if (!line.points.empty())
    {
      plot.curves.push_back(line);
      eightBits = eightBits || curve.eightBits;
    }
  }
  if (eightBits && scene.eightBitRmse > 0.0)
  {
    plot.levels.push_back({ "floor of 8 bit images", scene.eightBitRmse });
  }
  return plot;
}

// The time of the fastest of the methods at an RMSE.
std::optional<double> FastestAtError(
  const WorkPrecision& scene, const std::vector<std::string>& methods, double rmse)
{
  std::optional<double> fastest;
  for (const std::string& method : methods)
  {
    const WorkCurve* curve = CurveOf(scene, method);
    const std::optional<double> milliseconds =
      curve ? MillisecondsAtError(*curve, &ImageError::rootMeanSquare, rmse) : std::nullopt;
    if (milliseconds && *milliseconds < fastest.value_or(*milliseconds + 1.0))
    {
      fastest = milliseconds;
    }
  }
  return fastest;
}

}

LogLogPlot TimePlot(const WorkPrecision& scene)
{
  return ErrorPlot(scene, "median time of an image [ms]",
    [](const WorkPoint& point) { return std::optional<double>(point.medianMs); });
}

LogLogPlot FetchPlot(const WorkPrecision& scene)
{
  return ErrorPlot(
    scene, "mean fetches per pixel", [](const WorkPoint& point) { return point.fetchesPerPixel; });
}

std::vector<EqualErrorRow> EqualErrorRows(const WorkPrecision& scene)
{
  const WorkCurve* gpu = CurveOf(scene, "vtk-gpu");
  const WorkCurve* ours = CurveOf(scene, "optical");
  std::vector<EqualErrorRow> rows;
  if (gpu && ours)
  {
    for (const WorkPoint& point : gpu->points)
    {
      const double error = point.error.light.rootMeanSquare;
      rows.push_back({ VoxelsOf(scene, point), error, point.medianMs,
        MillisecondsAtError(*ours, &ImageError::rootMeanSquare, error) });
    }
  }
  return rows;
}

const std::vector<std::string>& OurMethods()
{
  static const std::vector<std::string> methods = { "tolerance", "optical", "pre-integrated" };
  return methods;
}

std::array<double, 2> ErrorsOf(const WorkCurve& curve)
{
  const auto [smallest, largest] = std::minmax_element(curve.points.begin(), curve.points.end(),
    [](const WorkPoint& a, const WorkPoint& b)
    { return a.error.light.rootMeanSquare < b.error.light.rootMeanSquare; });
  return { smallest->error.light.rootMeanSquare, largest->error.light.rootMeanSquare };
}

std::optional<WorstRatio> WorstAgainstVtk(
  const WorkPrecision& scene, const std::vector<std::string>& methods)
{
  constexpr int Errors = 200; // number of errors, evenly spaced in the plot
  const WorkCurve* vtk = CurveOf(scene, "vtk-gpu");
  if (!vtk ||
    std::none_of(methods.begin(), methods.end(),
      [&](const std::string& method) { return CurveOf(scene, method); }))
  {
    return std::nullopt;
  }
  const auto [smallest, largest] = ErrorsOf(*vtk);
  WorstRatio worst = { largest, std::numeric_limits<double>::infinity() };
  for (int i = 0; i <= Errors && worst.times; ++i)
  {
    const double rmse =
      std::max(largest * std::pow(smallest / largest, double(i) / Errors), smallest);
    const double vtkMs = *MillisecondsAtError(*vtk, &ImageError::rootMeanSquare, rmse);
    const std::optional<double> oursMs = FastestAtError(scene, methods, rmse);
    if (!oursMs || vtkMs / *oursMs < *worst.times)
    {
      worst = { rmse, oursMs ? std::optional<double>(vtkMs / *oursMs) : std::nullopt };
    }
  }
  return worst;
}

std::string PlotStem(const WorkPrecision& scene)
{
  return scene.name + "-time";
}

std::string TableText(const std::vector<WorkPrecision>& scenes)
{
  std::ostringstream text;
  text << std::left << std::setw(24) << "scene" << std::right << std::setw(12) << "VTK voxels"
       << std::setw(12) << "RMSE /255" << std::setw(12) << "VTK ms" << std::setw(12) << "ours ms"
       << std::setw(16) << "times as fast\n";
  for (const WorkPrecision& scene : scenes)
  {
    for (const EqualErrorRow& row : EqualErrorRows(scene))
    {
      text << std::left << std::setw(24) << scene.name << std::right << std::setw(12)
           << Fixed(row.voxels, 3) << std::setw(12) << Fixed(row.rmse, 3) << std::setw(12)
           << Fixed(row.vtkMs, 1) << std::setw(12) << (row.oursMs ? Fixed(*row.oursMs, 1) : "-")
           << std::setw(15) << (row.oursMs ? Fixed(row.vtkMs / *row.oursMs, 2) : "-") << "\n";
    }
  }
  return text.str() + "Times of our optical field are those at the error of VTK's GPU mapper.\n";
}

std::string TableCsv(const std::vector<WorkPrecision>& scenes)
{
  std::ostringstream csv;
  csv << "scene,method,renderer,setting,error_tolerance,voxels,sample_distance_mm,rmse_255,"
         "percentile_99_9_255,largest_255,"
         "ssim,ciede2000_mean,ciede2000_99,fetches_per_pixel,graphics_bytes,median_ms\n";
  csv.precision(9);
  for (const WorkPrecision& scene : scenes)
  {
    for (const WorkCurve& curve : scene.curves)
    {
      for (const WorkPoint& point : curve.points)
      {
        const ImageError& light = point.error.light;
        const PerceptualError& perceived = point.error.perceived;
        csv << scene.name << "," << curve.method.name << ","
            << NameOf(MapperKindNames(), curve.method.kind) << "," << point.setting.label << ","
            << OrNothing(ToleranceOf(point)) << "," << VoxelsOf(scene, point) << ","
            << point.sampleDistanceMm << "," << light.rootMeanSquare << "," << light.percentile999
            << "," << light.largest << "," << perceived.structuralSimilarity << ","
            << perceived.meanColorDifference << "," << perceived.colorDifference99 << ","
            << OrNothing(point.fetchesPerPixel) << "," << OrNothing(point.graphicsBytes) << ","
            << point.medianMs << "\n";
      }
    }
  }
  return csv.str();
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene)
{
  nlohmann::ordered_json json = { { "name", scene.name }, { "size", scene.scene.size },
    { "look", scene.scene.look.name }, { "openglRenderer", scene.openglRenderer },
    { "reference",
      { { "largestError255", 255.0 * scene.truth.largestError },
        { "seconds", scene.truth.seconds } } },
    { "eightBitRmse255", scene.eightBitRmse } };
  for (const WorkCurve& curve : scene.curves)
  {
    json["methods"].push_back(ToJson(scene, curve));
  }
  if (const auto worst = WorstAgainstVtk(scene, OurMethods()))
  {
    json["worstAgainstVtkGpu"] = { { "rmse255", worst->rmse } };
    if (worst->times)
    {
      json["worstAgainstVtkGpu"]["timesAsFast"] = *worst->times;
    }
  }
  for (const ToleranceRow& row : ToleranceRows(scene))
  {
    json["tolerances"].push_back(ToJson(row));
  }
  return json;
}

}
