#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Machine.h"
#include "Scene/OutputFile.h"
#include "TimesBench.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace varimarch
{

namespace
{

std::string MarkdownOf(const TimesCost& cost, const TimesArguments& arguments)
{
  std::ostringstream text;
  text << "# Times played\n\n`" << arguments.report.commandText << "`, " << TextOf(ThisMachine())
       << ".\n\n| | |\n|---|---:|\n| frames, each of another of " << arguments.times << " times | "
       << cost.frames << " |\n| frames a second, each time drawn first | "
       << Fixed(1000.0 / cost.newMs, 1) << " |\n| median time of such a frame [ms] | "
       << Fixed(cost.newMs, 1) << " |\n| frames a second, each time drawn again | "
       << (cost.againMs > 0.0 ? Fixed(1000.0 / cost.againMs, 1) : "-")
       << " |\n| median time of such a frame [ms] | " << Fixed(cost.againMs, 1)
       << " |\n| of it for the field [ms] | " << Fixed(cost.fieldMs, 1)
       << " |\n| median time of a frame of the same voxels [ms] | " << Fixed(cost.stillMs, 1)
       << " |\n| median time of a frame while somebody plays, 15 a second wanted [ms] | "
       << Fixed(cost.movingMs, 1) << " |\n| median distance between its rays [pixels] | "
       << Fixed(cost.movingRaysApart, 2) << " |\n| memory when each time was drawn once [MB] | "
       << Fixed(cost.residentMegabytesAtFirst, 0) << " |\n| memory at the end [MB] | "
       << Fixed(cost.residentMegabytesAtEnd, 0) << " |\n";
  return text.str();
}

nlohmann::ordered_json ToJson(const TimesCost& cost, const TimesArguments& arguments)
{
  return { { "command", arguments.report.commandText }, { "machine", ToJson(ThisMachine()) },
    { "times", arguments.times }, { "frames", cost.frames }, { "newMs", cost.newMs },
    { "againMs", cost.againMs }, { "fieldMs", cost.fieldMs }, { "stillMs", cost.stillMs },
    { "movingMs", cost.movingMs }, { "movingRaysApart", cost.movingRaysApart },
    { "residentMegabytesAtFirst", cost.residentMegabytesAtFirst },
    { "residentMegabytesAtEnd", cost.residentMegabytesAtEnd } };
}

}

void RunTimes(const TimesArguments& arguments)
{
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  SetInterruptNotice(folder.string(), "nothing yet");
  const auto [scene, volume] = LoadScene(arguments.scene, arguments.input);
  Progress progress("Rendering " + std::to_string(arguments.frames) + " frames");
  const TimesCost cost = CostOfTimes(scene, volume, arguments.times, arguments.frames,
    [&](int frame) { progress.SetActivity(std::to_string(frame) + " frames rendered"); });
  const std::string text = MarkdownOf(cost, arguments);
  WriteFileWhole(folder / "times.md", text);
  WriteResults(ToJson(cost, arguments), folder / "times.json");
  WriteResults(ToJson(cost, arguments), arguments.report.jsonPath);
  std::cout << text;
}

}
