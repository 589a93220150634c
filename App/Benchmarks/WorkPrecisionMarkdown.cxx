#include "WorkPrecisionMarkdown.h"

#include "CommandLine/Results.h"
#include "ToleranceReport.h"
#include "WorkPrecisionReport.h"

#include <algorithm>

namespace varimarch
{

namespace
{

const char* const Absent = "–";

std::string Row(const std::vector<std::string>& cells)
{
  std::string row = "|";
  for (const std::string& cell : cells)
  {
    row += " " + cell + " |";
  }
  return row + "\n";
}

// The two heading lines of a table whose first columns hold words, and the others numbers.
std::string Head(const std::vector<std::string>& headings, std::size_t words)
{
  std::string line = "|";
  for (std::size_t i = 0; i < headings.size(); ++i)
  {
    line += i < words ? "---|" : "---:|";
  }
  return Row(headings) + line + "\n";
}

std::string Link(const WorkPrecision& scene)
{
  return "[" + scene.name + "](" + PlotStem(scene) + ".svg)";
}

// The speed-up of a method over VTK at an error, given VTK's time.
std::string TimesAsFast(
  const WorkPrecision& scene, const std::string& method, double error, double vtkMs)
{
  const WorkCurve* curve = CurveOf(scene, method);
  if (!curve)
  {
    return Absent;
  }
  const auto milliseconds = MillisecondsAtError(*curve, &ImageError::rootMeanSquare, error);
  return milliseconds ? Fixed(vtkMs / *milliseconds, 1) : "never";
}

std::string SmallestError(const WorkPrecision& scene, const std::string& method)
{
  const WorkCurve* curve = CurveOf(scene, method);
  return curve ? Fixed(ErrorsOf(*curve)[0], 2) : Absent;
}

std::vector<std::string> CellsAt(
  const WorkPrecision& scene, const WorkPoint& vtk, const std::vector<std::string>& methods)
{
  const double error = vtk.error.light.rootMeanSquare;
  std::vector<std::string> cells = { Fixed(error, 2), Fixed(vtk.medianMs, 0) };
  for (const std::string& method : methods)
  {
    cells.push_back(TimesAsFast(scene, method, error, vtk.medianMs));
  }
  return cells;
}

// VTK's setting that is nearest to one sample per voxel.
const WorkPoint& NearOneVoxel(const WorkPrecision& scene, const WorkCurve& vtk)
{
  const auto ratio = [&](const WorkPoint& point)
  { return std::max(VoxelsOf(scene, point), 1.0 / VoxelsOf(scene, point)); };
  return *std::min_element(vtk.points.begin(), vtk.points.end(),
    [&](const WorkPoint& a, const WorkPoint& b) { return ratio(a) < ratio(b); });
}

std::string SpeedTable(const std::vector<WorkPrecision>& scenes)
{
  std::string text =
    "\n## Speed at VTK's error\n\nSpeed-up over VTK's GPU mapper at equal RMSE, interpolated along "
    "straight lines between settings in the plot; *never*: no setting has so small an error. "
    "Optical field: midpoints; pre-integrated: linear between samples; no field and fields at the "
    "sample distances that give this error. VTK CPU: the smallest RMSE of the fixed-point "
    "mapper.\n\n" +
    Head({ "scene", "VTK's RMSE at 1 voxel", "its ms", "error tolerances", "optical field",
           "pre-integrated", "no field", "cells, E 4/255", "published method",
           "VTK's RMSE at its finest", "its ms", "error tolerances", "optical field",
           "pre-integrated", "VTK CPU" },
      1);
  for (const WorkPrecision& scene : scenes)
  {
    const WorkCurve* vtk = CurveOf(scene, "vtk-gpu");
    if (!vtk)
    {
      continue;
    }
    std::vector<std::string> cells = { Link(scene) };
    for (const auto& more :
      { CellsAt(scene, NearOneVoxel(scene, *vtk),
          { "tolerance", "optical", "pre-integrated", "off", "cells-4", "published" }),
        CellsAt(scene, vtk->points.back(), { "tolerance", "optical", "pre-integrated" }),
        { SmallestError(scene, "vtk-cpu") } })
    {
      cells.insert(cells.end(), more.begin(), more.end());
    }
    text += Row(cells);
  }
  return text;
}

std::string WorstCell(const WorkPrecision& scene, const std::vector<std::string>& methods)
{
  const auto worst = WorstAgainstVtk(scene, methods);
  return !worst    ? Absent
    : worst->times ? Fixed(*worst->times, 2) + " at " + Fixed(worst->rmse, 2)
                   : "never " + Fixed(worst->rmse, 2);
}

std::string VerdictTable(const std::vector<WorkPrecision>& scenes)
{
  std::string text =
    "\n## Left of and below VTK's curve?\n\nThe smallest speed-up at any RMSE from VTK's largest "
    "to "
    "its smallest, and the RMSE at which it occurs; *yes*: above 1 everywhere. Ours: the best of "
    "error tolerances, optical field and pre-integrated at each error.\n\n" +
    Head({ "scene", "ours is", "VTK's RMSE", "ours", "error tolerances", "optical field",
           "pre-integrated", "published method" },
      2);
  std::size_t judged = 0;
  std::size_t good = 0;
  for (const WorkPrecision& scene : scenes)
  {
    const auto worst = WorstAgainstVtk(scene, OurMethods());
    if (!worst)
    {
      continue;
    }
    const bool yes = worst->times.value_or(0.0) > 1.0;
    const auto [smallest, largest] = ErrorsOf(*CurveOf(scene, "vtk-gpu"));
    ++judged;
    good += yes;
    text += Row({ Link(scene), yes ? "yes" : "**no**",
      Fixed(largest, 2) + " to " + Fixed(smallest, 2), WorstCell(scene, OurMethods()),
      WorstCell(scene, { "tolerance" }), WorstCell(scene, { "optical" }),
      WorstCell(scene, { "pre-integrated" }), WorstCell(scene, { "published" }) });
  }
  return text + "\nYes on " + std::to_string(good) + " of " + std::to_string(judged) + " scenes.\n";
}

std::string ToleranceTable(const std::vector<WorkPrecision>& scenes)
{
  std::vector<std::string> headings = ToleranceHeadings();
  headings.insert(headings.begin(), "scene");
  std::string text =
    "\n## Error tolerances\n\n" + ToleranceExplanation() + "\n\n" + Head(headings, 2);
  std::size_t all = 0;
  std::size_t kept = 0;
  for (const WorkPrecision& scene : scenes)
  {
    for (const ToleranceRow& row : ToleranceRows(scene))
    {
      std::vector<std::string> cells = ToleranceCells(row);
      ++all;
      kept += cells.back().empty();
      cells.back() = cells.back().empty() ? "" : "**" + cells.back() + "**";
      cells.insert(cells.begin(), scene.name);
      text += Row(cells);
    }
  }
  return text + "\nNothing missed in " + std::to_string(kept) + " of " + std::to_string(all) +
    " rows.\n";
}

// The row of a method at the setting that its picture shows.
std::vector<std::string> CellsOf(const WorkPrecision& scene, const WorkCurve& curve)
{
  const WorkPoint& point = curve.points[curve.shown];
  constexpr double Megabyte = 1e6;
  std::vector<std::string> cells = { scene.name, curve.method.title, point.setting.label,
    Fixed(point.error.light.rootMeanSquare, 2), Fixed(point.medianMs, 1),
    point.fetchesPerPixel ? Fixed(*point.fetchesPerPixel, 1) : Absent,
    point.graphicsBytes ? Fixed(*point.graphicsBytes / Megabyte, 1) : Absent };
  if (!curve.orbit)
  {
    cells.insert(cells.end(), 3, Absent);
    return cells;
  }
  cells.insert(cells.end(),
    { Fixed(curve.orbit->median, 3), Fixed(curve.orbit->largest, 3),
      Fixed(curve.orbit->largestAtDegrees, 0) });
  return cells;
}

std::string MethodTable(const std::vector<WorkPrecision>& scenes)
{
  std::string text = "\n## All methods near one sample per voxel\n\nChange: RMSE of the change of "
                     "the error between neighbouring frames of an orbit of " +
    Fixed(OrbitDegrees, 0) +
    " degrees, against our mapper at eight samples per voxel; a largest change far above the "
    "median is a pop. MB: textures of the method, in 10^6 bytes.\n\n" +
    Head({ "scene", "method", "setting", "RMSE", "ms", "fetches per pixel", "MB", "median change",
           "largest change", "at [degrees]" },
      3);
  for (const WorkPrecision& scene : scenes)
  {
    for (const WorkCurve& curve : scene.curves)
    {
      text += Row(CellsOf(scene, curve));
    }
  }
  return text;
}

}

std::string WorkPrecisionMarkdown(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page)
{
  const Machine& machine = page.machine;
  std::string text = "# Work and precision\n\n" + machine.processor + ", " +
    std::to_string(machine.cores) + " cores, OpenGL renderer \"" + scenes.front().openglRenderer +
    "\", VTK " + machine.vtkVersion + ", " + machine.date + ", load before the start " +
    Fixed(machine.load, 1) + ". Made by\n\n    " + page.commandText +
    "\n\nErrors are the RMSE of float images in 1/255 of premultiplied RGBA without background, "
    "against an adaptive integral of each ray in double precision. Times are medians of "
    "alternating rounds: compare the ratios. Links lead to plots.\n" +
    SpeedTable(scenes) + VerdictTable(scenes) + ToleranceTable(scenes) + MethodTable(scenes);
  for (const WorkPrecision& scene : scenes)
  {
    for (const WorkCurve& curve : scene.curves)
    {
      text += curve.skipped.empty() ? ""
                                    : "\n" + scene.name + ": " + curve.method.title +
          " was not run at " + curve.skipped + ".\n";
    }
  }
  return text;
}

}
