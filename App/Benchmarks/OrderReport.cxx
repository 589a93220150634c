#include "OrderReport.h"

#include "CommandLine/Results.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace varimarch
{

namespace
{

std::string FittedOrder(const OrderCurve& curve)
{
  return curve.fit ? Fixed(curve.fit->order, 2) + " ± " + Fixed(curve.fit->halfWidth, 2) : "-";
}

std::string FittedRange(const OrderExperiment& experiment)
{
  return std::isinf(experiment.widestFitted)
    ? std::string()
    : "Fitted from " + experiment.widthName + " " + Fixed(experiment.widestFitted, 0) + " on.\n\n";
}

std::string OrderRow(const OrderCurve& curve)
{
  return "| " + curve.method + " | " + (curve.expected ? Fixed(*curve.expected, 0) : "-") + " | " +
    FittedOrder(curve) + " | " + std::to_string(curve.fit ? curve.fit->points : 0) + " of " +
    std::to_string(curve.points.size()) + " | " + Fixed(curve.points.front().rmse, 3) + " | " +
    Fixed(curve.points.back().rmse, 4) + " |\n";
}

}

std::string OrderMarkdown(const OrderPage& page)
{
  std::string text = "# Observed orders of convergence\n\n" + page.machine.processor + ", VTK " +
    page.machine.vtkVersion + ", " + page.machine.date + ", images of " +
    std::to_string(page.side) + " x " + std::to_string(page.side) + " pixels. Made by `" +
    page.commandText +
    "`.\n\nErrors are RMSE in 1/255. Orders are slopes fitted to all errors "
    "above " +
    Fixed(OrderFloor, 4) + ", with their 95 % confidence.\n";
  for (const OrderExperiment& experiment : page.experiments)
  {
    text += "\n## " + experiment.title + "\n\n![Error over " + experiment.widthName + "](" +
      experiment.name + ".svg)\n\n" + FittedRange(experiment) +
      "| method | expected | observed order | fitted to | error, coarsest | error, finest |\n"
      "|---|---:|---:|---:|---:|---:|\n";
    for (const OrderCurve& curve : experiment.curves)
    {
      text += OrderRow(curve);
    }
  }
  return text;
}

std::string OrderCsv(const OrderPage& page)
{
  std::ostringstream text;
  text << "experiment,method,width,rmse_255,largest_255\n";
  for (const OrderExperiment& experiment : page.experiments)
  {
    for (const OrderCurve& curve : experiment.curves)
    {
      for (const OrderPoint& point : curve.points)
      {
        text << experiment.name << ",\"" << curve.method << "\"," << point.width << ','
             << point.rmse << ',' << point.largest << '\n';
      }
    }
  }
  return text.str();
}

nlohmann::ordered_json ToJson(const OrderPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "side", page.side },
    { "experiments", nlohmann::ordered_json::array() } };
  for (const OrderExperiment& experiment : page.experiments)
  {
    nlohmann::ordered_json entry = { { "name", experiment.name }, { "width", experiment.widthName },
      { "methods", nlohmann::ordered_json::array() } };
    for (const OrderCurve& curve : experiment.curves)
    {
      nlohmann::ordered_json method = { { "method", curve.method } };
      if (curve.expected)
      {
        method["expectedOrder"] = *curve.expected;
      }
      if (curve.fit)
      {
        method["order"] = curve.fit->order;
        method["orderHalfWidth95"] = curve.fit->halfWidth;
        method["fittedPoints"] = curve.fit->points;
      }
      for (const OrderPoint& point : curve.points)
      {
        method["points"].push_back(
          { { "width", point.width }, { "rmse255", point.rmse }, { "largest255", point.largest } });
      }
      entry["methods"].push_back(method);
    }
    json["experiments"].push_back(entry);
  }
  return json;
}

LogLogPlot OrderPlot(const OrderExperiment& experiment)
{
  LogLogPlot plot = { experiment.title, experiment.widthName, "RMSE [1/255]", {}, {} };
  for (const OrderCurve& curve : experiment.curves)
  {
    PlotCurve line = { curve.method + ", order " + FittedOrder(curve), curve.style, {} };
    for (const OrderPoint& point : curve.points)
    {
      if (point.rmse > 0.0)
      {
        line.points.push_back({ point.width, point.rmse });
      }
    }
    if (!line.points.empty())
    {
      plot.curves.push_back(line);
    }
  }
  return plot;
}

}
