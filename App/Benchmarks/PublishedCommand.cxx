#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "PublishedReport.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

void Write(const PublishedPage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  WriteFileWhole(folder / "published.md", PublishedMarkdown(page));
  const nlohmann::ordered_json results = ToJson(page);
  WriteResults(results, folder / "published.json");
  WriteResults(results, report.jsonPath);
  SetInterruptNotice(folder,
    std::to_string(page.measured.dataSets.size() + page.measured.volt.size()) + " of the scenes");
}

}

void RunPublished(const PublishedArguments& arguments)
{
  constexpr int LargestSide = 256; // side of each picture in a figure [pixels]
  SetInterruptNotice(OutputFolder(arguments.report.outputFolder), "nothing yet");
  PublishedPage page = { arguments.report.commandText, ThisMachine(), {}, {} };
  {
    Progress progress("Measuring the published scenes");
    page.figures = DrawPublishedFigures(arguments.options.folder,
      std::min(arguments.options.side, LargestSide), arguments.report.outputFolder,
      [&](const std::string& step) { progress.SetActivity(step); });
    MeasurePublished(
      arguments.options, [&](const std::string& step) { progress.SetActivity(step); },
      [&](const PublishedMeasurements& measured)
      {
        page.measured = measured;
        Write(page, arguments.report);
      });
  }
  std::cout << PublishedMarkdown(page);
}

}
