#include "LightMethodsReport.h"

#include "CommandLine/PictureError.h"
#include "CommandLine/Results.h"
#include "Scene/Median.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

template <class Number>
std::vector<double> OfAllScenes(const LightMethodsPage& page, std::size_t method, Number number)
{
  std::vector<double> numbers;
  for (const LightMethodsCase& measured : page.cases)
  {
    numbers.push_back(number(measured, measured.methods[method]));
  }
  return numbers;
}

// The geometric mean, over all scenes, of a time relative to ours, which is the first method.
double TimesOurs(const LightMethodsPage& page, std::size_t method, double LightMethodCost::*time)
{
  double sum = 0.0;
  for (const LightMethodsCase& measured : page.cases)
  {
    sum += std::log(measured.methods[method].*time / (measured.methods.front().*time));
  }
  return std::exp(sum / double(page.cases.size()));
}

std::string SummaryRow(const LightMethodsPage& page, std::size_t method)
{
  const auto percentiles = OfAllScenes(page, method,
    [](const LightMethodsCase&, const LightMethodCost& cost) { return cost.error.percentile999; });
  const auto rmse = OfAllScenes(page, method,
    [](const LightMethodsCase&, const LightMethodCost& cost) { return cost.error.rootMeanSquare; });
  const auto megabytes = OfAllScenes(page, method,
    [](const LightMethodsCase&, const LightMethodCost& cost) { return cost.lightMegabytes; });
  return "| " + LightMethods()[method].name + " | " + LightMethods()[method].title + " | " +
    Fixed(Median(rmse), 2) + " | " + Fixed(Median(percentiles), 1) + " | " +
    Fixed(*std::max_element(percentiles.begin(), percentiles.end()), 1) + " | " +
    Fixed(TimesOurs(page, method, &LightMethodCost::stillMs), 2) + " | " +
    Fixed(TimesOurs(page, method, &LightMethodCost::draggedMs), 2) + " | " +
    Fixed(*std::max_element(megabytes.begin(), megabytes.end()), 2) + " |\n";
}

std::string SceneRow(const LightMethodsCase& measured)
{
  std::string row = "| " + measured.scene + " |";
  for (const LightMethodCost& cost : measured.methods)
  {
    row += " " + Fixed(cost.error.percentile999, 1) + " | " + Fixed(cost.stillMs, 0) + " |";
  }
  return row + "\n";
}

std::string SceneTable(const LightMethodsPage& page)
{
  std::string text = "| scene |";
  std::string line = "|---|";
  for (const LightMethod& method : LightMethods())
  {
    text += " " + method.name + " | ms |";
    line += "---:|---:|";
  }
  text += "\n" + line + "\n";
  for (const LightMethodsCase& measured : page.cases)
  {
    text += SceneRow(measured);
  }
  return text;
}

}

std::string MarkdownOf(const LightMethodsPage& page)
{
  const std::string side = std::to_string(page.run.options.side);
  std::string text = "# Methods of light\n\n" + TextOf(page.run.machine) + ". " +
    std::to_string(page.cases.size()) + " scenes, images of " + side + " x " + side +
    ", one light fixed in the world, medians of " + std::to_string(page.run.options.rounds) +
    " alternating rounds. Ours has an error tolerance of " +
    Fixed(255.0 * page.run.options.errorTolerance, 2) +
    " of 255; the samples and slices of all others are a voxel apart. Errors [1/255] are against "
    "our own rays with samples " +
    Fixed(FineDistanceVoxels(page.run.options.errorTolerance), 3) +
    " of a voxel apart. Made by\n\n    " + page.run.commandText +
    "\n\n## All scenes together\nMedians of the errors and the largest of 99.9 % of the pixels; "
    "geometric means of the times, relative to ours; the most memory for light.\n\n"
    "| method | what it is | RMSE | 99.9 % | largest 99.9 % | still | light dragged | MB |\n"
    "|---|---|---:|---:|---:|---:|---:|---:|\n";
  for (std::size_t method = 0; method < LightMethods().size(); ++method)
  {
    text += SummaryRow(page, method);
  }
  return text +
    "\n## Each scene\nThe error of 99.9 % of the pixels [1/255], and the time of a frame of a "
    "still "
    "camera [ms].\n\n" +
    SceneTable(page);
}

std::string CsvOf(const LightMethodsPage& page)
{
  std::string text =
    "scene,method,first_ms,still_ms,dragged_ms,rmse,percentile999,largest,light_megabytes\n";
  for (const LightMethodsCase& measured : page.cases)
  {
    for (std::size_t i = 0; i < measured.methods.size(); ++i)
    {
      const LightMethodCost& cost = measured.methods[i];
      text += measured.scene + ",\"" + LightMethods()[i].name + "\"";
      for (const double number :
        { cost.firstMs, cost.stillMs, cost.draggedMs, cost.error.rootMeanSquare,
          cost.error.percentile999, cost.error.largest, cost.lightMegabytes })
      {
        text += "," + Fixed(number, 3);
      }
      text += "\n";
    }
  }
  return text;
}

nlohmann::ordered_json ToJson(const LightMethodsPage& page)
{
  nlohmann::ordered_json json = ToJson(page.run);
  for (const LightMethodsCase& measured : page.cases)
  {
    nlohmann::ordered_json methods;
    for (std::size_t i = 0; i < measured.methods.size(); ++i)
    {
      const LightMethodCost& cost = measured.methods[i];
      methods[LightMethods()[i].name] = { { "firstMs", cost.firstMs }, { "stillMs", cost.stillMs },
        { "draggedMs", cost.draggedMs }, { "lightMegabytes", cost.lightMegabytes },
        { "error", ToJson(cost.error) } };
    }
    json["scenes"].push_back({ { "scene", measured.scene }, { "methods", methods } });
  }
  return json;
}

}
