#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "OrderReport.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

void Write(const OrderPage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  const nlohmann::ordered_json results = ToJson(page);
  WriteResults(results, folder / "order.json");
  WriteResults(results, report.jsonPath);
  WriteFileWhole(folder / "order.csv", OrderCsv(page));
  WriteFileWhole(folder / "order.md", OrderMarkdown(page));
  WritePlot(OrderPlot(page.experiments.back()), folder / page.experiments.back().name);
  SetInterruptNotice(report.outputFolder, "orders up to " + page.experiments.back().title);
}

}

void RunOrder(const OrderArguments& arguments)
{
  SetInterruptNotice(OutputFolder(arguments.report.outputFolder), "nothing yet");
  OrderPage page = { arguments.report.commandText, ThisMachine(), arguments.side, {} };
  {
    Progress progress("Measuring orders of convergence");
    MeasureOrders(
      arguments.side, [&](const std::string& step) { progress.SetActivity(step); },
      [&](const std::vector<OrderExperiment>& experiments)
      {
        page.experiments = experiments;
        Write(page, arguments.report);
      });
  }
  std::cout << OrderMarkdown(page);
}

}
