#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Machine.h"
#include "Scene/OutputFile.h"
#include "SoakBench.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace varimarch
{

namespace
{

/// The measurements of `varimarch-bench soak`, and how they were made.
struct SoakPage
{
  std::string commandText;
  Machine machine;
  std::vector<SoakPart> parts;
};

std::string Markdown(const SoakPage& page)
{
  std::ostringstream text;
  text << "# A long run\n\n`" << page.commandText << "`, " << page.machine.processor << ", "
       << page.machine.date << ".\n\n"
       << "| frames | median time of a frame [ms] | memory [MB] | open files | threads |\n"
       << "|---:|---:|---:|---:|---:|\n";
  for (const SoakPart& part : page.parts)
  {
    text << "| " << part.frames << " | " << Fixed(part.medianMs, 1) << " | "
         << Fixed(part.residentMegabytes, 0) << " | " << part.openFiles << " | " << part.threads
         << " |\n";
  }
  if (page.parts.size() == SoakParts)
  {
    text << "\nThe last tenth takes "
         << Fixed(page.parts.back().medianMs / page.parts.front().medianMs, 2)
         << " times as long as the first.\n";
  }
  return text.str();
}

nlohmann::ordered_json ToJson(const SoakPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "parts", nlohmann::ordered_json::array() } };
  for (const SoakPart& part : page.parts)
  {
    json["parts"].push_back({ { "frames", part.frames }, { "medianMs", part.medianMs },
      { "residentMegabytes", part.residentMegabytes }, { "openFiles", part.openFiles },
      { "threads", part.threads } });
  }
  return json;
}

void Write(const SoakPage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  WriteFileWhole(folder / "soak.md", Markdown(page));
  WriteResults(ToJson(page), folder / "soak.json");
  WriteResults(ToJson(page), report.jsonPath);
}

}

void RunSoak(const SoakArguments& arguments)
{
  SetInterruptNotice(OutputFolder(arguments.report.outputFolder), "nothing yet");
  const auto [scene, volume] = LoadScene(arguments.scene, arguments.input);
  SoakPage page = { arguments.report.commandText, ThisMachine(), {} };
  {
    Progress progress("Rendering " + std::to_string(arguments.frames) + " frames");
    Soak(scene, volume, arguments.frames,
      [&](const SoakPart& part)
      {
        page.parts.push_back(part);
        Write(page, arguments.report);
        progress.SetActivity(std::to_string(part.frames) + " frames of " +
          std::to_string(arguments.frames) + " rendered");
        SetInterruptNotice(arguments.report.outputFolder, std::to_string(part.frames) + " frames");
      });
  }
  std::cout << Markdown(page);
}

}
