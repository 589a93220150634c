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
  "## Banquero, Ortiz, Rossi 2016, tables 1 and 2\n"
  "Their setup: NVIDIA GeForce GTX 660 Ti, Intel Core Duo 2.40 GHz. The paper does not state the\n"
  "image size and the transfer function; 60 frames per second are probably the display's limit.\n"
  "Steps are the texture fetches along a ray. The tables do not state the length of a ray, so\n"
  "here the volume's longest edge has as many samples. Table 2 does not state its steps; its\n"
  "figures are listed at 60, which the conclusion recommends. *Plain*: no field, published sum;\n"
  "*field*: the same with the field of variations, E = 4/255 of the range; *ours*: the optical\n"
  "field with the midpoint rule. RMSE in 1/255 of premultiplied RGBA.\n\n"
  "| volume | steps | their FPS, table 1 | plain / field, table 2 | plain [FPS] | RMSE "
  "| field [FPS] | RMSE | ours [FPS] | RMSE | field / plain | ours / plain |\n"
  "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

const char* const VoltHead =
  "\n## Volt 2009\n"
  "Their setup: an NVIDIA GPU of 2009 with CUDA. The text that we have gives registers (32\n"
  "shaded, 14 unshaded), but no frame rates. VIS MALE, values up to 40 clear, from 41 at one\n"
  "opacity per voxel edge, a sample every 0.49 of the shortest edge, early termination at 95 %\n"
  "(VTK's own limit cannot be set). Errors are measured against the image without early\n"
  "termination.\n\n"
  "| alpha [1/255] | shaded | ours [FPS] | RMSE | no field [FPS] | RMSE | VTK GPU [FPS] | RMSE |\n"
  "|---:|---|---:|---:|---:|---:|---:|---:|\n";

// Frames per second and error, as two cells.
std::string Cells(const WorkPoint& point)
{
  return Fixed(1000.0 / point.medianMs, 1) + " | " + Fixed(point.error.light.rootMeanSquare, 2) +
    " | ";
}

std::string OrNone(double fps)
{
  return fps > 0.0 ? Fixed(fps, 1) : "";
}

// Table 2 does not state its number of steps; the paper's conclusion recommends 60.
std::string Table2Cell(const PublishedVolume& volume, int steps)
{
  return steps == 60 ? Fixed(volume.plainFps, 0) + " / " + Fixed(volume.fieldFps, 0) : "";
}

std::string RowsOf(const MeasuredVolume& volume)
{
  std::string rows;
  for (std::size_t i = 0; i < std::size(PublishedSteps); ++i)
  {
    const WorkPoint& plain = volume.measured.curves[0].points[i];
    const WorkPoint& field = volume.measured.curves[1].points[i];
    const WorkPoint& ours = volume.measured.curves[2].points[i];
    rows += "| " + volume.published.name + " | " + std::to_string(PublishedSteps[i]) + " | " +
      OrNone(volume.published.stepsFps[i]) + " | " +
      Table2Cell(volume.published, PublishedSteps[i]) + " | " + Cells(plain) + Cells(field) +
      Cells(ours) + Fixed(plain.medianMs / field.medianMs, 2) + " | " +
      Fixed(plain.medianMs / ours.medianMs, 2) + " |\n";
  }
  return rows;
}

std::string RemarksOf(const PublishedMeasurements& measured)
{
  std::string remarks = "\nVolumes:";
  for (const MeasuredVolume& volume : measured.volumes)
  {
    remarks += " " + volume.published.name + ": " + volume.published.remark + ".";
  }
  for (const std::string& file : measured.missing)
  {
    remarks += " Not in the folder: " + file + ".";
  }
  return remarks + "\n";
}

std::string RowOf(const MeasuredVolt& volt)
{
  std::string row =
    "| " + std::to_string(volt.alpha255) + " | " + (volt.shaded ? "yes" : "no") + " | ";
  for (const WorkCurve& curve : volt.measured.curves)
  {
    row += Cells(curve.points.front());
  }
  row.pop_back();
  return row + "\n";
}

}

std::string PublishedMarkdown(const PublishedPage& page)
{
  const auto& size = page.measured.volumes.front().measured.scene.size;
  std::string text = "# Published scenes\n\nOurs: " + page.machine.processor + ", " +
    std::to_string(page.machine.cores) + " cores, OpenGL renderer \"" +
    page.measured.volumes.front().measured.openglRenderer + "\", images of " +
    std::to_string(size[0]) + " x " + std::to_string(size[1]) + ", " + page.machine.date +
    ", load before the start " + Fixed(page.machine.load, 1) + ". Made by `" + page.commandText +
    "`.\nIf ours is a CPU, frame rates are not comparable with theirs: compare the ratios.\n\n" +
    BanqueroHead;
  for (const MeasuredVolume& volume : page.measured.volumes)
  {
    text += RowsOf(volume);
  }
  text += RemarksOf(page.measured);
  if (!page.measured.volt.empty())
  {
    text += VoltHead;
  }
  for (const MeasuredVolt& volt : page.measured.volt)
  {
    text += RowOf(volt);
  }
  return text;
}

nlohmann::ordered_json ToJson(const PublishedPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "missing", page.measured.missing } };
  for (const MeasuredVolume& volume : page.measured.volumes)
  {
    json["banquero"].push_back(
      { { "volume", volume.published.name }, { "file", volume.published.file },
        { "steps", PublishedSteps }, { "publishedFps", volume.published.stepsFps },
        { "publishedPlainFps", volume.published.plainFps },
        { "publishedFieldFps", volume.published.fieldFps },
        { "measured", ToJson(volume.measured) } });
  }
  for (const MeasuredVolt& volt : page.measured.volt)
  {
    json["volt"].push_back({ { "alpha255", volt.alpha255 }, { "shaded", volt.shaded },
      { "measured", ToJson(volt.measured) } });
  }
  return json;
}

}
