#include "PublishedReport.h"

#include "CommandLine/Results.h"
#include "WorkPrecisionReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace varimarch
{

namespace
{

const char* const BanqueroHead =
  "## Banquero, Ortiz, Rossi 2016\n"
  "Their setup: NVIDIA GeForce GTX 660 Ti, Intel Core Duo 2.40 GHz. The paper does not state the\n"
  "image size, the transfer function, the step and the first distance; 60 frames per second are\n"
  "probably the display's limit. Here the transfer function is a grey ramp, clear at its lower\n"
  "end, rays begin where they enter the volume, and nothing ends them early, as in the printed\n"
  "loop. All volumes are resampled to the sizes of the paper, in bytes. The loop runs in a\n"
  "shader, line by line (`VolumeModule/Shaders/March/PublishedSum.glsl`). *Readings* are fetches\n"
  "from the volume per pixel; with the field, each has one from the field beside it. RMSE is in\n"
  "1/255 of premultiplied RGBA, against an adaptive integral of each whole ray.\n";

const char* const Table1Head =
  "\n### Table 1: the number of steps\n"
  "The paper calls 120 steps almost half of a volume of 256 voxels, so a step is one voxel, the\n"
  "smallest spacing. Rays that short do not reach the far side, which is most of the error.\n\n"
  "| data set | size | steps | FPS, theirs | FPS, ours | readings | RMSE |\n"
  "|---|---|---:|---:|---:|---:|---:|\n";

const char* const Table2Head =
  "\n### Table 2: ray casting (RC) and distance field (DF)\n"
  "E = 4/255 of the range. The paper does not state its steps, so rays are whole.\n\n"
  "| data set | size | FPS RC, theirs | FPS DF, theirs | DF / RC, theirs | step [voxels] | FPS RC |"
  " FPS DF | DF / RC | readings RC | readings DF | RMSE RC | RMSE DF |\n"
  "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

const char* const ToleranceHead =
  "\n### Ours, at the error of their field\n"
  "The coarsest error tolerance whose RMSE is not above that of DF, by packets of rays on the CPU\n"
  "and by shaders.\n\n"
  "| data set | size | step of DF | RMSE DF | FPS DF | readings DF | tolerance | RMSE | FPS |"
  " FPS, shaders | readings, shaders |\n"
  "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

const char* const PromiseHead =
  "\n### The field, and how often it is wrong\n"
  "S promises that voxels closer than S(p) differ from voxel p by less than E = 4/255. A ray\n"
  "meets interpolated values, at places between voxels. 200000 jumps from random places in random\n"
  "directions: the part that goes two voxels or more, the part of these that meets a value which\n"
  "differs by E or more from the first, and the largest such difference in 1/255.\n\n"
  "| data set | size | built in [s] | mean S, ball | mean S, cube | jumps of two voxels or more |"
  " broken | by up to |\n"
  "|---|---|---:|---:|---:|---:|---:|---:|\n";

const char* const VoltHead =
  "\n## Volt 2009\n"
  "Their setup: an NVIDIA GPU of 2009 with CUDA. The text that we have gives registers (32\n"
  "shaded, 14 unshaded), but no frame rates. VIS MALE, values up to 40 clear, from 41 at one\n"
  "opacity per voxel edge, a sample every 0.49 of the shortest edge, early termination at 95 %\n"
  "(VTK's own limit cannot be set). Shaded light is damped where the gradient is below 10/255 per\n"
  "voxel, which VTK's mapper does not have. Errors are measured against the image without early\n"
  "termination.\n\n"
  "| alpha [1/255] | shaded | ours [FPS] | RMSE | no field [FPS] | RMSE | VTK GPU [FPS] | RMSE |\n"
  "|---:|---|---:|---:|---:|---:|---:|---:|\n";

std::string Fps(const WorkPoint& point)
{
  return Fixed(1000.0 / point.medianMs, 1);
}

std::string Readings(const WorkPoint& point)
{
  return point.fetchesPerPixel ? Fixed(*point.fetchesPerPixel, 1) : "";
}

std::string Rmse(const WorkPoint& point)
{
  return Fixed(point.error.light.rootMeanSquare, 2);
}

std::string Row(const std::vector<std::string>& cells)
{
  std::string row = "|";
  for (const std::string& cell : cells)
  {
    row += " " + cell + " |";
  }
  return row + "\n";
}

std::string SizeOf(const PublishedDataSet& published)
{
  const std::string side = std::to_string(published.side);
  return side + " x " + side + " x " + side;
}

std::string Table1Rows(const MeasuredDataSet& set)
{
  std::string rows;
  for (std::size_t i = 0; i < set.published.steps.size(); ++i)
  {
    const WorkPoint& point = CurveOf(set.measured, "steps")->points[i];
    const PublishedSteps& theirs = set.published.steps[i];
    rows += Row({ set.published.name, SizeOf(set.published), std::to_string(theirs.steps),
      Fixed(theirs.fps, 1), Fps(point), Readings(point), Rmse(point) });
  }
  return rows;
}

std::string Table2Rows(const MeasuredDataSet& set)
{
  std::string rows;
  for (std::size_t i = 0; set.published.rates && i < std::size(PublishedStepVoxels); ++i)
  {
    const PublishedRates& theirs = *set.published.rates;
    const WorkPoint& plain = CurveOf(set.measured, "rc")->points[i];
    const WorkPoint& field = CurveOf(set.measured, "df")->points[i];
    rows += Row({ set.published.name, SizeOf(set.published), theirs.plainFps, theirs.fieldFps,
      theirs.ratio, Fixed(PublishedStepVoxels[i], 1), Fps(plain), Fps(field),
      Fixed(plain.medianMs / field.medianMs, 2), Readings(plain), Readings(field), Rmse(plain),
      Rmse(field) });
  }
  return rows;
}

std::string ToleranceRows(const MeasuredDataSet& set)
{
  std::string rows;
  for (std::size_t i = 0; set.published.rates && i < std::size(PublishedStepVoxels); ++i)
  {
    const WorkPoint& field = CurveOf(set.measured, "df")->points[i];
    const std::vector<WorkPoint>& ours = CurveOf(set.measured, "tolerance")->points;
    const auto first = std::find_if(ours.begin(), ours.end(),
      [&](const WorkPoint& point)
      { return point.error.light.rootMeanSquare <= field.error.light.rootMeanSquare; });
    std::vector<std::string> cells = { set.published.name, SizeOf(set.published),
      Fixed(PublishedStepVoxels[i], 1), Rmse(field), Fps(field), Readings(field) };
    if (first == ours.end())
    {
      cells.insert(cells.end(), { "none", "", "", "", "" });
    }
    else
    {
      const WorkPoint& shader =
        CurveOf(set.measured, "tolerance-shader")->points[std::size_t(first - ours.begin())];
      cells.insert(cells.end(),
        { first->setting.label, Rmse(*first), Fps(*first), Fps(shader), Readings(shader) });
    }
    rows += Row(cells);
  }
  return rows;
}

std::string PromiseRow(const MeasuredDataSet& set)
{
  if (!set.promise)
  {
    return {};
  }
  const PublishedPromise& promise = *set.promise;
  return Row({ set.published.name, SizeOf(set.published), Fixed(promise.buildSeconds, 1),
    Fixed(promise.meanEuclidean, 2), Fixed(promise.meanChebyshev, 2),
    Fixed(100.0 * promise.longJumps, 1) + " %", Fixed(100.0 * promise.brokenJumps, 2) + " %",
    Fixed(promise.largest, 0) });
}

std::string RemarksOf(const PublishedMeasurements& measured)
{
  std::string remarks = "\nOur volumes before they were resampled:";
  std::string last;
  for (const MeasuredDataSet& set : measured.dataSets)
  {
    const std::string remark = " " + set.published.name + ": " + set.published.remark + ".";
    remarks += remark == last ? "" : remark;
    last = remark;
  }
  for (const std::string& file : measured.missing)
  {
    remarks += " Not in the folder: " + file + ".";
  }
  return remarks + "\n";
}

std::string RowOf(const MeasuredVolt& volt)
{
  std::vector<std::string> cells = { std::to_string(volt.alpha255), volt.shaded ? "yes" : "no" };
  for (const WorkCurve& curve : volt.measured.curves)
  {
    cells.insert(cells.end(), { Fps(curve.points.front()), Rmse(curve.points.front()) });
  }
  cells.resize(8);
  return Row(cells);
}

template <class Scenes, class RowsOf>
std::string Table(const char* head, const Scenes& scenes, const RowsOf& rowsOf)
{
  std::string rows;
  for (const auto& scene : scenes)
  {
    rows += rowsOf(scene);
  }
  return rows.empty() ? rows : head + rows;
}

std::string IntroductionOf(const PublishedPage& page)
{
  const WorkPrecision& first = page.measured.dataSets.front().measured;
  return "# Published scenes\n\nOurs: " + page.machine.processor + ", " +
    std::to_string(page.machine.cores) + " cores, OpenGL renderer \"" + first.openglRenderer +
    "\", images of " + std::to_string(first.scene.size[0]) + " x " +
    std::to_string(first.scene.size[1]) + ", " + page.machine.date + ", load before the start " +
    Fixed(page.machine.load, 1) + ". Made by `" + page.commandText +
    "`.\nIf ours is a CPU, frame rates are not comparable with theirs: compare the ratios.\n\n";
}

}

std::string PublishedMarkdown(const PublishedPage& page)
{
  const std::vector<MeasuredDataSet>& sets = page.measured.dataSets;
  std::string text = IntroductionOf(page) + BanqueroHead + RemarksOf(page.measured) +
    Table(Table1Head, sets, Table1Rows) + Table(Table2Head, sets, Table2Rows) +
    Table(ToleranceHead, sets, ToleranceRows) + Table(PromiseHead, sets, PromiseRow);
  for (const PublishedFigure& figure : page.figures)
  {
    text += "\n" + figure.text + "\n\n![](" + figure.file + ")\n";
  }
  return text + Table(VoltHead, page.measured.volt, RowOf);
}

nlohmann::ordered_json ToJson(const PublishedPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "missing", page.measured.missing } };
  for (const MeasuredDataSet& set : page.measured.dataSets)
  {
    nlohmann::ordered_json row = { { "dataSet", set.published.name },
      { "side", set.published.side }, { "file", set.published.file } };
    if (set.promise)
    {
      row.update({ { "buildSeconds", set.promise->buildSeconds },
        { "meanEuclidean", set.promise->meanEuclidean },
        { "meanChebyshev", set.promise->meanChebyshev }, { "longJumps", set.promise->longJumps },
        { "brokenJumps", set.promise->brokenJumps },
        { "largestDifference", set.promise->largest } });
    }
    row["measured"] = ToJson(set.measured);
    json["banquero"].push_back(row);
  }
  for (const MeasuredVolt& volt : page.measured.volt)
  {
    json["volt"].push_back({ { "alpha255", volt.alpha255 }, { "shaded", volt.shaded },
      { "measured", ToJson(volt.measured) } });
  }
  return json;
}

}
