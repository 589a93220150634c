#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "ExtremesReport.h"
#include "Scene/OutputFile.h"

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

void Write(const ExtremesPage& page, const std::filesystem::path& folder)
{
  WriteFileWhole(folder / "extremes.csv", ExtremesCsv(page));
  WriteFileWhole(folder / "extremes.md", ExtremesMarkdown(page));
  SetInterruptNotice(folder, "scenes up to " + page.measurements.back().name);
}

}

void RunExtremes(const ExtremesArguments& arguments)
{
  const std::filesystem::path folder = OutputFolder(arguments.outputFolder);
  SetInterruptNotice(folder, "nothing yet");
  ExtremesPage page = { arguments.commandText, ThisMachine(), {} };
  {
    Progress progress("Measuring extreme scenes");
    MeasureExtremes(
      arguments.only, [&](const std::string& step) { progress.SetActivity(step); },
      [&](const std::vector<ExtremeMeasurement>& measurements)
      {
        page.measurements = measurements;
        Write(page, folder);
      });
  }
  std::cout << ExtremesMarkdown(page);
}

}
