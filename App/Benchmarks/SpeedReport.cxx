#include "SpeedReport.h"

#include "CommandLine/Results.h"
#include "Scene/SceneNames.h"
#include "SpeedSummary.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

const char* const TargetsHead =
  "\n## Targets\n"
  "Our speed-up over another method, at the largest error tolerance at which our RMSE meets the\n"
  "target. VTK's mappers and the published method, with E = 4/255, take one "
  "sample\n"
  "per voxel; our march without a field keeps a tolerance of 1/64. Means are geometric.\n\n"
  "| against | shaded | size | scenes | mean | target | least | target | least on | verdict |\n"
  "|---|---|---:|---:|---:|---:|---:|---:|---|---|\n";

const char* const KeepingHead =
  "\n## Scene by scene\n"
  "Times are medians of still images: of five, or as many as take 50 ms. *Times as fast* is the\n"
  "median of the rounds, in each of which both were drawn one right after the other. RMSE in\n"
  "1/255 of premultiplied RGBA, against an adaptive integral in double precision. *Our tolerance*\n"
  "is an error in [0, 1].\n\n"
  "| scene | shaded | size | rival | rival [ms] | rival RMSE | ours | our tolerance | ours [ms] "
  "| our RMSE | times as fast |\n"
  "|---|---|---:|---|---:|---:|---|---:|---:|---:|---:|\n";

const char* const DefaultsHead =
  "\n## Every setting\n"
  "*First*: first image of a new window and mapper, with the volume in memory. *Rebuild*: extra "
  "time\n"
  "of the image after a change of transfer function, compared with the next one; it includes the\n"
  "tolerance search. *Field*: time to build the field for the first image; *field again*: time to\n"
  "rebuild it after the change. *Memory*: graphics memory of the mapper. *Fetches*: from the "
  "volume\n"
  "by a shader, mean of all pixels. VTK's mappers do not report the last four.\n\n"
  "| scene | shaded | size | method | tolerance | RMSE | 99.9 % | still [ms] | first [ms] "
  "| rebuild [ms] | field [ms] | field again [ms] | memory [MiB] | fetches | rounds |\n"
  "|---|---|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

std::string CaseCells(const SpeedCase& measured)
{
  return "| " + measured.scene + " | " + (measured.shaded ? "yes" : "no") + " | " +
    std::to_string(measured.side) + " | ";
}

// A tolerance such as 1/64; a dash if none is used.
std::string ToleranceText(const SpeedPoint& point)
{
  const bool used = IsOurs(point.kind) && !point.options.sampleDistanceMm;
  return used ? "1/" + Fixed(1.0 / point.options.errorTolerance, 0) : "-";
}

std::string TargetRow(const SpeedSummary& summary)
{
  const SpeedTarget& target = SpeedTargets()[summary.target];
  const bool any = !summary.timesAsFast.empty();
  std::string row = "| " + target.title + " | " + (summary.shaded ? "yes" : "no") + " | " +
    std::to_string(summary.side) + " | " +
    std::to_string(summary.timesAsFast.size() + summary.failing.size()) + " | " +
    Fixed(summary.geometricMean, 2) + " | " + Fixed(target.timesWanted, 0) + " | " +
    (any ? Fixed(summary.timesAsFast.front(), 2) : "-") + " | " +
    (target.timesAtLeast > 0.0 ? Fixed(target.timesAtLeast, 0) : "-") + " | " + summary.worstScene +
    " | " + (summary.IsMet() ? "met" : "**missed**");
  for (std::size_t i = 0; i < summary.failing.size(); ++i)
  {
    row += (i == 0 ? "; no tolerance keeps the error on " : ", ") + summary.failing[i];
  }
  return row + " |\n";
}

std::string KeepingRows(const SpeedCase& measured)
{
  std::string rows;
  for (std::size_t i = 0; i < SpeedTargets().size(); ++i)
  {
    const SpeedPoint* rival = Rival(measured, SpeedTargets()[i]);
    if (!rival)
    {
      continue;
    }
    rows += CaseCells(measured) + rival->method + " | " + Fixed(rival->median.stillMs, 1) + " | " +
      Fixed(rival->error.rootMeanSquare, 2) + " | " + SpeedTargets()[i].ours + " | ";
    if (const auto times = TimesAsFast(measured, i))
    {
      const SpeedPoint& ours = measured.points[*measured.keeping[i]];
      rows += ToleranceText(ours) + " | " + Fixed(ours.median.stillMs, 1) + " | " +
        Fixed(ours.error.rootMeanSquare, 2) + " | " + Fixed(*times, 2) + " |\n";
    }
    else
    {
      rows += "none | - | - | - |\n";
    }
  }
  return rows;
}

std::string PointRow(const SpeedCase& measured, const SpeedPoint& point)
{
  const FrameCost& cost = point.median;
  const bool ours = IsOurs(point.kind);
  return CaseCells(measured) + point.method + " | " + ToleranceText(point) + " | " +
    Fixed(point.error.rootMeanSquare, 2) + " | " + Fixed(point.error.percentile999, 1) + " | " +
    Fixed(cost.stillMs, 1) + " | " + Fixed(cost.firstMs, 1) + " | " + Fixed(cost.rebuildMs, 1) +
    " | " + (ours ? Fixed(cost.firstFieldMs, 1) : "-") + " | " +
    (ours ? Fixed(cost.changeFieldMs, 1) : "-") + " | " + Mebibytes(point.graphicsBytes) + " | " +
    (point.fetchesPerPixel ? Fixed(*point.fetchesPerPixel, 1) : "-") + " | " +
    std::to_string(point.rounds.size()) + " |\n";
}

std::string Heading(const SpeedPage& page)
{
  std::string text = "# Speed\n\n" + page.machine.processor + ", " +
    std::to_string(page.machine.cores) + " cores, OpenGL renderer \"" +
    page.cases.front().openglRenderer + "\", VTK " + page.machine.vtkVersion + ", " +
    page.machine.date + ", load before the start " + Fixed(page.machine.load, 1) +
    ". Medians of up to " + std::to_string(page.options.rounds) +
    " rounds;\nan image that takes more than " + Fixed(page.options.longestSeconds, 1) +
    " s is drawn in only one. Made by `" + page.commandText + "`.\n";
  for (std::size_t i = 0; i < page.missing.size(); ++i)
  {
    text += (i == 0 ? "Not in the folder: " : ", ") + page.missing[i];
  }
  return text + (page.missing.empty() ? "" : ".\n");
}

nlohmann::ordered_json ToJson(const SpeedPoint& point)
{
  nlohmann::ordered_json json = { { "method", point.method },
    { "renderer", NameOf(MapperKindNames(), point.kind) } };
  if (point.options.sampleDistanceMm)
  {
    json["sampleDistanceMm"] = *point.options.sampleDistanceMm;
  }
  else
  {
    json["errorTolerance"] = point.options.errorTolerance;
  }
  json["error255"] = { { "rmse", point.error.rootMeanSquare },
    { "percentile99.9", point.error.percentile999 }, { "largest", point.error.largest } };
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  json["median"] = ToJson(point.median);
  for (const FrameCost& cost : point.rounds)
  {
    json["rounds"].push_back(ToJson(cost));
  }
  return json;
}

nlohmann::ordered_json ToJson(const SpeedCase& measured)
{
  nlohmann::ordered_json json = { { "scene", measured.scene }, { "shaded", measured.shaded },
    { "side", measured.side }, { "openglRenderer", measured.openglRenderer } };
  for (const SpeedPoint& point : measured.points)
  {
    json["points"].push_back(ToJson(point));
  }
  for (std::size_t i = 0; i < SpeedTargets().size(); ++i)
  {
    if (const auto times = TimesAsFast(measured, i))
    {
      json["keeping"].push_back(
        { { "rival", SpeedTargets()[i].rival }, { "point", *measured.keeping[i] },
          { "timesAsFast", *times }, { "rounds", measured.timesAsFast[i] } });
    }
  }
  return json;
}

nlohmann::ordered_json ToJson(const SpeedSummary& summary)
{
  const SpeedTarget& target = SpeedTargets()[summary.target];
  return { { "against", target.title }, { "shaded", summary.shaded }, { "side", summary.side },
    { "timesAsFast", summary.geometricMean }, { "target", target.timesWanted },
    { "least", summary.timesAsFast.empty() ? 0.0 : summary.timesAsFast.front() },
    { "leastTarget", target.timesAtLeast }, { "leastOn", summary.worstScene },
    { "errorNotKeptOn", summary.failing }, { "met", summary.IsMet() } };
}

}

std::string SpeedMarkdown(const SpeedPage& page)
{
  std::string text = Heading(page) + TargetsHead;
  for (const SpeedSummary& summary : SpeedSummaries(page.cases))
  {
    text += TargetRow(summary);
  }
  text += KeepingHead;
  for (const SpeedCase& measured : page.cases)
  {
    text += KeepingRows(measured);
  }
  text += DefaultsHead;
  for (const SpeedCase& measured : page.cases)
  {
    for (const SpeedPoint& point : measured.points)
    {
      text += PointRow(measured, point);
    }
  }
  return text;
}

nlohmann::ordered_json ToJson(const SpeedPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "missing", page.missing } };
  for (const SpeedSummary& summary : SpeedSummaries(page.cases))
  {
    json["targets"].push_back(ToJson(summary));
  }
  for (const SpeedCase& measured : page.cases)
  {
    json["cases"].push_back(ToJson(measured));
  }
  return json;
}

nlohmann::ordered_json ToJson(const FrameCost& cost)
{
  return { { "firstMs", cost.firstMs }, { "stillMs", cost.stillMs },
    { "rebuildMs", cost.rebuildMs }, { "firstFieldMs", cost.firstFieldMs },
    { "changeFieldMs", cost.changeFieldMs } };
}

std::string Mebibytes(const std::optional<double>& bytes)
{
  return bytes ? Fixed(*bytes / (1 << 20), 1) : "-";
}

}
