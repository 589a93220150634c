#include "ComparisonReport.h"

#include "Results.h"
#include "Scene/Json/SceneNames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace varimarch
{

namespace
{

using Row = std::vector<std::string>;

// The rows of the table, rounded for reading, with the heading first.
std::vector<Row> Rows(const Comparison& comparison)
{
  std::vector<Row> rows = { { "renderer", "class", "sample distance [mm]", "RMSE", "99.9 %",
    "largest", "median [ms]", "times as fast as VTK GPU" } };
  for (const Measurement& measurement : comparison.measurements)
  {
    rows.push_back({ NameOf(MapperKindNames(), measurement.kind), ClassName(measurement.kind),
      Fixed(measurement.sampleDistanceMm, 3), Fixed(measurement.error.light.rootMeanSquare, 3),
      Fixed(measurement.error.light.percentile999, 2), Fixed(measurement.error.light.largest, 2),
      Fixed(measurement.medianMs, 1), Fixed(RatioToVtkGpu(comparison, measurement), 2) });
  }
  return rows;
}

// Adds the columns of perceived differences, which are too wide for a terminal.
void AddPerceived(const Comparison& comparison, std::vector<Row>& rows)
{
  rows[0].insert(rows[0].end(), { "SSIM", "CIEDE2000 mean", "CIEDE2000 99 %" });
  for (std::size_t i = 0; i < comparison.measurements.size(); ++i)
  {
    const PerceptualError& perceived = comparison.measurements[i].error.perceived;
    rows[i + 1].insert(rows[i + 1].end(),
      { Fixed(perceived.structuralSimilarity, 5), Fixed(perceived.meanColorDifference, 3),
        Fixed(perceived.colorDifference99, 2) });
  }
}

std::string Explanation(const Comparison& comparison)
{
  return "Errors in 1/255 of premultiplied RGBA, against " + Described(comparison.truth) +
    ". Times: medians of " + std::to_string(comparison.measurements.front().roundsMs.size()) +
    " alternating rounds on OpenGL renderer \"" + comparison.openglRenderer + "\".\n";
}

std::string Joined(const Row& row, const std::string& separator)
{
  std::string line;
  for (const std::string& cell : row)
  {
    line += (line.empty() ? "" : separator) + cell;
  }
  return line;
}

}

double RatioToVtkGpu(const Comparison& comparison, const Measurement& measurement)
{
  const auto gpu = std::find_if(comparison.measurements.begin(), comparison.measurements.end(),
    [](const Measurement& other) { return other.kind == MapperKind::VtkGpu; });
  return gpu->medianMs / measurement.medianMs;
}

std::string ClassName(MapperKind kind)
{
  switch (kind)
  {
    case MapperKind::VtkGpu:
      return "vtkOpenGLGPUVolumeRayCastMapper";
    case MapperKind::VtkCpu:
      return "vtkFixedPointVolumeRayCastMapper";
    case MapperKind::VarimarchShaders:
      return "vtkVariationFieldVolumeMapper, shaders";
    default:
      return "vtkVariationFieldVolumeMapper";
  }
}

std::string TableText(const Comparison& comparison)
{
  constexpr std::size_t FirstNumber = 2;
  const std::vector<Row> rows = Rows(comparison);
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows)
  {
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      widths[column] = std::max(widths[column], row[column].size());
    }
  }
  std::string text;
  for (const Row& row : rows)
  {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      const std::string padding(widths[column] - row[column].size(), ' ');
      line += (column ? "  " : "") +
        (column < FirstNumber ? row[column] + padding : padding + row[column]);
    }
    text += line + "\n";
  }
  return text + Explanation(comparison);
}

std::string TableMarkdown(const Comparison& comparison, const std::string& commandText)
{
  std::vector<Row> rows = Rows(comparison);
  AddPerceived(comparison, rows);
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    text += "| " + Joined(rows[i], " | ") + " |\n";
    text += i == 0 ? "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n" : "";
  }
  return text + "\n" + Explanation(comparison) + "\nMade by: `" + commandText + "`\n";
}

std::string TableCsv(const Comparison& comparison)
{
  std::ostringstream csv;
  csv << "renderer,class,sample_distance_mm,rmse_255,percentile_99_9_255,largest_255,median_ms,"
         "times_as_fast_as_vtk_gpu,ssim,ciede2000_mean,ciede2000_99\n";
  csv.precision(9);
  for (const Measurement& measurement : comparison.measurements)
  {
    csv << NameOf(MapperKindNames(), measurement.kind) << "," << ClassName(measurement.kind) << ","
        << measurement.sampleDistanceMm << "," << measurement.error.light.rootMeanSquare << ","
        << measurement.error.light.percentile999 << "," << measurement.error.light.largest << ","
        << measurement.medianMs << "," << RatioToVtkGpu(comparison, measurement) << ","
        << measurement.error.perceived.structuralSimilarity << ","
        << measurement.error.perceived.meanColorDifference << ","
        << measurement.error.perceived.colorDifference99 << "\n";
  }
  return csv.str();
}

nlohmann::ordered_json ToJson(const Comparison& comparison)
{
  nlohmann::ordered_json json;
  json["openglRenderer"] = comparison.openglRenderer;
  json["reference"] = { { "largestError255", 255.0 * comparison.truth.largestError },
    { "seconds", comparison.truth.seconds }, { "paths", comparison.truth.paths.paths } };
  for (const Measurement& measurement : comparison.measurements)
  {
    nlohmann::ordered_json row = { { "renderer", NameOf(MapperKindNames(), measurement.kind) },
      { "class", ClassName(measurement.kind) },
      { "sampleDistanceMm", measurement.sampleDistanceMm } };
    row.update(ToJson(measurement.error));
    row.update({ { "firstMs", measurement.firstMs }, { "roundsMs", measurement.roundsMs },
      { "medianMs", measurement.medianMs },
      { "timesAsFastAsVtkGpu", RatioToVtkGpu(comparison, measurement) } });
    json["renderers"].push_back(row);
  }
  return json;
}

}
