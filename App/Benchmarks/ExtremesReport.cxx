#include "ExtremesReport.h"

#include "CommandLine/Results.h"
#include "Scene/SceneNames.h"

#include <algorithm>
#include <sstream>

namespace varimarch
{

namespace
{

// The default error tolerance of our mapper [1/255].
constexpr double Tolerance = 255.0 / 64.0;

std::string TitleOf(MapperKind kind)
{
  return NameOf(MapperKindNames(), kind);
}

// The RMSE and the error that 99.9 % of the pixels keep, or a word that says more.
std::string ErrorText(const ExtremeResult& result)
{
  if (!result.wasTried)
  {
    return "not tried";
  }
  if (!result.isFinite)
  {
    return "**not finite**";
  }
  return result.isEmpty
    ? "**empty**"
    : Fixed(result.error.rootMeanSquare, 2) + " / " + Fixed(result.error.percentile999, 2);
}

std::string SceneRow(const ExtremeMeasurement& measurement)
{
  std::string row = "| " + measurement.name + " |";
  for (const ExtremeResult& result : measurement.results)
  {
    row += " " + ErrorText(result) + (result.message.empty() ? "" : " \\*") + " |";
  }
  for (const ExtremeResult& result : measurement.results)
  {
    row += " " + (result.wasTried ? Fixed(result.medianMs, 1) : std::string("-")) + " |";
  }
  return row + "\n";
}

struct Summary
{
  int tried = 0;
  int kept = 0;
  int notFinite = 0;
  int empty = 0;
  int said = 0; ///< wrong, with a message that says so
};

Summary SummaryOf(const std::vector<ExtremeMeasurement>& measurements, std::size_t mapper)
{
  Summary summary;
  for (const ExtremeMeasurement& measurement : measurements)
  {
    const ExtremeResult& result = measurement.results[mapper];
    const bool isKept = result.isFinite && result.error.percentile999 <= Tolerance;
    summary.tried += result.wasTried;
    summary.kept += result.wasTried && isKept;
    summary.notFinite += result.wasTried && !result.isFinite;
    summary.empty += result.wasTried && result.isEmpty;
    summary.said += result.wasTried && !isKept && !result.message.empty();
  }
  return summary;
}

std::string SummaryTable(const std::vector<ExtremeMeasurement>& measurements)
{
  std::string text =
    "| mapper | scenes | within 4 of 255 | further off | of these with a message | "
    "empty | not finite |\n|---|---:|---:|---:|---:|---:|---:|\n";
  for (std::size_t i = 0; i < ExtremeMappers().size(); ++i)
  {
    const Summary summary = SummaryOf(measurements, i);
    text += "| " + TitleOf(ExtremeMappers()[i]);
    for (const int count : { summary.tried, summary.kept, summary.tried - summary.kept,
           summary.said, summary.empty, summary.notFinite })
    {
      text += " | " + std::to_string(count);
    }
    text += " |\n";
  }
  return text;
}

std::string TableHead()
{
  std::string head = "| scene |";
  std::string line = "|---|";
  for (const char* const measured : { "", " [ms]" })
  {
    for (const MapperKind kind : ExtremeMappers())
    {
      head += " " + TitleOf(kind) + measured + " |";
      line += "---:|";
    }
  }
  return head + "\n" + line + "\n";
}

}

std::string ExtremesMarkdown(const ExtremesPage& page)
{
  const std::string side = std::to_string(ExtremesSide);
  std::string text = "# Extreme scenes\n\n" + TextOf(page.machine) + ". Made by `" +
    page.commandText + "`.\n\n" + SummaryTable(page.measurements) +
    "\nBelow: the RMSE / the error that 99.9 % of the pixels keep [1/255], of images of " + side +
    " x " + side +
    " pixels, and the time of a frame. \\*: with a warning or an error. All mappers have their\n"
    "defaults, except that VTK's fixed-point mapper samples as finely as its GPU mapper does.\n";
  std::string group;
  for (const ExtremeMeasurement& measurement : page.measurements)
  {
    if (measurement.group != group)
    {
      group = measurement.group;
      text += "\n## " + group + "\n\n" + TableHead();
    }
    text += SceneRow(measurement);
  }
  return text;
}

std::string ExtremesCsv(const ExtremesPage& page)
{
  std::ostringstream text;
  text
    << "group,scene,mapper,tried,rmse_255,percentile_99_9_255,largest_255,finite,empty,median_ms,"
       "message\n";
  for (const ExtremeMeasurement& measurement : page.measurements)
  {
    for (const ExtremeResult& result : measurement.results)
    {
      std::string message = result.message;
      std::replace(message.begin(), message.end(), '"', '\'');
      std::replace(message.begin(), message.end(), '\n', ' ');
      text << measurement.group << ',' << measurement.name << ',' << TitleOf(result.kind) << ','
           << (result.wasTried ? "yes" : "no") << ',' << result.error.rootMeanSquare << ','
           << result.error.percentile999 << ',' << result.error.largest << ','
           << (result.isFinite ? "yes" : "no") << ',' << (result.isEmpty ? "yes" : "no") << ','
           << result.medianMs << ",\"" << message << "\"\n";
    }
  }
  return text.str();
}

}
