#include "ScalingReport.h"

#include "CommandLine/Results.h"
#include "Scene/SceneNames.h"
#include "SpeedReport.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

/// A time that the plot shows.
struct PlottedTime
{
  std::string title;
  MapperKind kind;
  double FrameCost::*time;
  std::array<unsigned char, 3> color;
  Marker marker;
};

// Colours of M. Okabe, K. Ito, "Color universal design", 2008.
const std::vector<PlottedTime>& PlottedTimes()
{
  static const std::vector<PlottedTime> times = {
    { "ours, still", MapperKind::Varimarch, &FrameCost::stillMs, { 0, 114, 178 }, Marker::Circle },
    { "ours, first", MapperKind::Varimarch, &FrameCost::firstMs, { 86, 180, 233 },
      Marker::Diamond },
    { "ours, field", MapperKind::Varimarch, &FrameCost::firstFieldMs, { 0, 158, 115 },
      Marker::Cross },
    { "VTK GPU, still", MapperKind::VtkGpu, &FrameCost::stillMs, { 213, 94, 0 }, Marker::Square },
    { "VTK GPU, first", MapperKind::VtkGpu, &FrameCost::firstMs, { 230, 159, 0 }, Marker::Plus },
  };
  return times;
}

std::string Row(const ScalingCurve& curve, const ScalingPoint& point)
{
  const FrameCost& cost = point.median;
  const bool ours = curve.kind == MapperKind::Varimarch;
  return "| " + curve.volume + " | " + NameOf(MapperKindNames(), curve.kind) + " | " +
    std::to_string(point.side) + " | " + Fixed(cost.stillMs, 1) + " | " + Fixed(cost.firstMs, 1) +
    " | " + Fixed(cost.rebuildMs, 1) + " | " + (ours ? Fixed(cost.firstFieldMs, 2) : "-") + " | " +
    (ours ? Fixed(cost.changeFieldMs, 2) : "-") + " | " + Mebibytes(point.graphicsBytes) + " | " +
    (point.fetchesPerPixel ? Fixed(*point.fetchesPerPixel, 1) : "-") + " |\n";
}

nlohmann::ordered_json ToJson(const ScalingPoint& point)
{
  nlohmann::ordered_json json = { { "side", point.side }, { "median", ToJson(point.median) } };
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  for (const FrameCost& cost : point.rounds)
  {
    json["rounds"].push_back(ToJson(cost));
  }
  return json;
}

}

std::string ScalingMarkdown(const ScalingPage& page)
{
  std::string text = "# Time over the size of the volume\n\n" + TextOf(page.machine) +
    ", images of " + std::to_string(page.size[0]) + " x " + std::to_string(page.size[1]) +
    ", medians of " + std::to_string(page.rounds) + " alternating rounds. Made by `" +
    page.commandText +
    "`.\n\nOurs uses its error tolerance, VTK's GPU mapper its own choice of samples; errors are "
    "not measured.\n\n"
    "| volume | renderer | side [voxels] | still [ms] | first [ms] | rebuild [ms] | field [ms] "
    "| field again [ms] | memory [MiB] | fetches |\n"
    "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const ScalingCurve& curve : page.curves)
  {
    for (const ScalingPoint& point : curve.points)
    {
      text += Row(curve, point);
    }
  }
  for (const ScalingCurve& curve : page.curves)
  {
    if (!curve.stopped.empty())
    {
      text += "\n" + curve.volume + ", " + NameOf(MapperKindNames(), curve.kind) +
        ": no larger volume (" + curve.stopped + ")\n";
    }
  }
  return text;
}

nlohmann::ordered_json ToJson(const ScalingPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "size", page.size } };
  for (const ScalingCurve& curve : page.curves)
  {
    nlohmann::ordered_json row = { { "volume", curve.volume },
      { "renderer", NameOf(MapperKindNames(), curve.kind) }, { "stopped", curve.stopped } };
    for (const ScalingPoint& point : curve.points)
    {
      row["points"].push_back(ToJson(point));
    }
    json["curves"].push_back(row);
  }
  return json;
}

LogLogPlot ScalingPlot(const std::vector<ScalingCurve>& curves)
{
  LogLogPlot plot = { "Time over the size of the volume", "side of the volume [voxels]",
    "median time [ms]", {}, {} };
  for (const ScalingCurve& curve : curves)
  {
    const bool first = curve.volume == curves.front().volume;
    for (const PlottedTime& plotted : PlottedTimes())
    {
      PlotCurve line = { curve.volume + ": " + plotted.title,
        { plotted.color, plotted.marker, first ? Stroke::Solid : Stroke::Dashed }, {} };
      for (const ScalingPoint& point : curve.points)
      {
        const double milliseconds = point.median.*plotted.time;
        if (plotted.kind == curve.kind && milliseconds > 0.0)
        {
          line.points.push_back({ double(point.side), milliseconds });
        }
      }
      if (!line.points.empty())
      {
        plot.curves.push_back(line);
      }
    }
  }
  return plot;
}

}
