#include "FeatureReport.h"

#include "CommandLine/Results.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

std::string Row(const FeatureMeasurement& measured)
{
  const std::string start = "| " + measured.feature->name + " | " + measured.feature->over + " | ";
  if (!measured.failure.empty())
  {
    return start + "failed | | | | | | |\n";
  }
  const FeatureCost& ours = measured.ours;
  const FeatureCost& vtk = measured.vtk;
  const std::string ourPart = start + Fixed(ours.beforeMs, 1) + " | " + Fixed(ours.onMs, 1) +
    " | " + Fixed(ours.Ratio(), 2) + " | " + Fixed(ours.afterMs / ours.beforeMs, 2) + " | ";
  if (!measured.feature->isVtks)
  {
    return ourPart + "- | - | - |\n";
  }
  return ourPart + Fixed(vtk.onMs, 1) + " | " + Fixed(vtk.Ratio(), 2) + " | " +
    (measured.vtkShowsNothing ? "-" : Fixed(vtk.onMs / ours.onMs, 2)) + " |\n";
}

// Footnotes about features that our mapper or VTK's does not draw.
std::string Notes(const std::vector<FeatureMeasurement>& features)
{
  std::string notes;
  for (const FeatureMeasurement& measured : features)
  {
    if (!measured.failure.empty())
    {
      notes += "- " + measured.feature->name + " failed: " + measured.failure + "\n";
    }
    else if (!measured.drawnByVtk.empty())
    {
      notes += "- " + measured.feature->name +
        " is left to VTK's mapper by the plugin: " + measured.drawnByVtk + "\n";
    }
    if (!measured.feature->isVtks)
    {
      notes += "- " + measured.feature->name + ": VTK's mapper does not have this feature\n";
    }
    else if (measured.vtkShowsNothing)
    {
      notes += "- " + measured.feature->name + ": VTK's mapper shows nothing\n";
    }
  }
  return notes.empty() ? "" : "\n" + notes;
}

nlohmann::ordered_json ToJson(const FeatureCost& cost)
{
  return { { "beforeMs", cost.beforeMs }, { "onMs", cost.onMs }, { "afterMs", cost.afterMs } };
}

}

std::string FeatureMarkdown(const FeaturePage& page)
{
  std::string text = "# What features cost\n\n" + page.volume + ", " + TextOf(page.machine) +
    ", images of " + std::to_string(page.size[0]) + " x " + std::to_string(page.size[1]) +
    " of a moving camera, medians of " + std::to_string(page.rounds) +
    " alternating rounds. Made by `" + page.commandText +
    "`.\n\nOurs is the plugin's mapper at its error tolerance; VTK's takes one sample per voxel. "
    "With: time with the feature. Cost: ratio of the times with and without it. Off again: ratio "
    "of the times after the feature is switched off and before it was switched on.\n\n"
    "| feature | over | ours without [ms] | ours with [ms] | our cost | off again | VTK with [ms] "
    "| VTK's cost | VTK / ours |\n|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const FeatureMeasurement& measured : page.features)
  {
    text += Row(measured);
  }
  return text + Notes(page.features);
}

nlohmann::ordered_json ToJson(const FeaturePage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "volume", page.volume }, { "size", page.size },
    { "rounds", page.rounds } };
  for (const FeatureMeasurement& measured : page.features)
  {
    json["features"].push_back({ { "name", measured.feature->name },
      { "over", measured.feature->over }, { "ours", ToJson(measured.ours) },
      { "vtk", ToJson(measured.vtk) }, { "drawnByVtk", measured.drawnByVtk },
      { "vtkShowsNothing", measured.vtkShowsNothing }, { "failure", measured.failure } });
  }
  return json;
}

}
