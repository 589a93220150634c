#include "ToleranceReport.h"

#include "CommandLine/Results.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace varimarch
{

namespace
{

constexpr double SlowestRatio = 2.0;

// Finds our fastest hand-chosen setting with the same 99.9th percentile.
void AddHandTuned(const WorkPrecision& scene, double percentile255, ToleranceRow& row)
{
  for (const char* method : { "optical", "pre-integrated", "simpson" })
  {
    const WorkCurve* curve = CurveOf(scene, method);
    const std::optional<double> milliseconds =
      curve ? MillisecondsAtError(*curve, &ImageError::percentile999, percentile255) : std::nullopt;
    if (milliseconds && *milliseconds < row.handMs.value_or(*milliseconds + 1.0))
    {
      row.handMs = milliseconds;
      row.handMethod = method;
    }
  }
}

std::optional<double> RatioOf(const ToleranceRow& row)
{
  return row.handMs ? std::optional<double>(row.milliseconds / *row.handMs) : std::nullopt;
}

std::string MissedOf(const ToleranceRow& row)
{
  std::string missed;
  missed += row.percentile999 > 1.0 ? "99.9 % " : "";
  missed += row.largest > 2.0 ? "largest " : "";
  missed += RatioOf(row).value_or(0.0) > SlowestRatio ? "time " : "";
  return missed.empty() ? "" : missed.substr(0, missed.size() - 1);
}

}

std::optional<double> ToleranceOf(const WorkPoint& point)
{
  const RenderOptions& options = point.setting.options;
  return options.sampleDistanceMm ? std::nullopt : std::optional<double>(options.errorTolerance);
}

std::vector<ToleranceRow> ToleranceRows(const WorkPrecision& scene)
{
  std::vector<ToleranceRow> rows;
  const WorkCurve* curve = CurveOf(scene, "tolerance");
  for (const WorkPoint& point : curve ? curve->points : std::vector<WorkPoint>())
  {
    const double tolerance = *ToleranceOf(point);
    const ImageError& error = point.error.light;
    rows.push_back({ point.setting.label, tolerance, error.percentile999 / 255.0 / tolerance,
      error.largest / 255.0 / tolerance, point.estimatedError / tolerance, point.medianMs, "",
      std::nullopt });
    AddHandTuned(scene, error.percentile999, rows.back());
  }
  return rows;
}

std::vector<std::string> ToleranceHeadings()
{
  return { "setting", "99.9 % of it", "largest of it", "estimate of it", "ms", "by hand", "its ms",
    "ratio", "missed" };
}

std::vector<std::string> ToleranceCells(const ToleranceRow& row)
{
  const std::optional<double> ratio = RatioOf(row);
  return { row.label, Fixed(row.percentile999, 2), Fixed(row.largest, 2), Fixed(row.estimate, 2),
    Fixed(row.milliseconds, 1), row.handMs ? row.handMethod : "none so precise",
    row.handMs ? Fixed(*row.handMs, 1) : "-", ratio ? Fixed(*ratio, 2) : "-", MissedOf(row) };
}

std::string ToleranceExplanation()
{
  return "Errors are fractions of the tolerance; the promise is at most 1 for 99.9 % of the "
         "pixels, "
         "and at most 2 for the largest. By hand: the fastest of optical, pre-integrated and "
         "simpson at the same measured 99.9th percentile; the promise is at most twice its time. "
         "Missed: the promises that are not kept. Times are those of a still view, without the "
         "tolerance search of a new view.";
}

std::string ToleranceText(const std::vector<WorkPrecision>& scenes)
{
  constexpr int Width = 16;
  std::ostringstream text;
  const auto addLine = [&](const std::string& scene, const std::vector<std::string>& cells)
  {
    text << std::left << std::setw(20) << scene;
    for (const std::string& cell : cells)
    {
      text << std::right << std::setw(Width) << cell;
    }
    text << "\n";
  };
  for (const WorkPrecision& scene : scenes)
  {
    for (const ToleranceRow& row : ToleranceRows(scene))
    {
      if (text.tellp() == 0)
      {
        addLine("scene", ToleranceHeadings());
      }
      addLine(scene.name, ToleranceCells(row));
    }
  }
  return text.tellp() == 0 ? "" : text.str() + ToleranceExplanation() + "\n";
}

nlohmann::ordered_json ToJson(const ToleranceRow& row)
{
  nlohmann::ordered_json json = { { "setting", row.label }, { "errorTolerance", row.tolerance },
    { "percentile99.9OfTolerance", row.percentile999 }, { "largestOfTolerance", row.largest },
    { "estimateOfTolerance", row.estimate }, { "medianMs", row.milliseconds } };
  if (row.handMs)
  {
    json.update({ { "handTuned", row.handMethod }, { "handTunedMs", *row.handMs },
      { "timesHandTuned", *RatioOf(row) } });
  }
  json["missed"] = MissedOf(row);
  return json;
}

}
