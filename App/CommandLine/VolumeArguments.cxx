#include "VolumeArguments.h"

#include "ArgumentChecks.h"
#include "Messages.h"
#include "Progress.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Volumes/RawGuess.h"
#include "UsageError.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

namespace varimarch
{

namespace
{

const std::string ProceduralPrefix = "procedural:";

/// The number that a text is; empty if it is anything else.
template <class Number>
std::optional<Number> NumberOf(const std::string& text)
{
  Number number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional<Number>(number) : std::nullopt;
}

void ThrowIf(const std::string& problem)
{
  if (!problem.empty())
  {
    throw UsageError("VOLUME: " + problem);
  }
}

// Parses an input such as "procedural:torso" or "procedural:torso:128x128x64".
ProceduralSource ProceduralFromInput(const std::string& input)
{
  const std::string rest = input.substr(ProceduralPrefix.size());
  const std::size_t colon = rest.find(':');
  const std::string name = rest.substr(0, colon);
  ThrowIf(NameProblem(name, NamesOf(ProceduralNames())));
  ProceduralSource source;
  source.kind = ValueOf(ProceduralNames(), name);
  if (colon != std::string::npos)
  {
    const std::string size = rest.substr(colon + 1);
    ThrowIf(SidesProblem<3>(size, "128x128x64", 2, LargestProceduralSide));
    source.dimensions = *Sides<3>(size, 2, LargestProceduralSide);
  }
  return source;
}

bool HasRawLayout(const VolumeArguments& arguments)
{
  return arguments.raw.dimensions[0] > 0;
}

// The message that asks for the dimensions of a raw file, with a suggestion that fits its name and
// size.
std::string MissingDimensions(const std::string& path)
{
  const std::string needed = "needed for the raw voxels of " + path;
  const auto fileBytes = std::int64_t(std::filesystem::file_size(path));
  const RawLayout guess = GuessedRawLayout(path, fileBytes);
  if (BytesOf(guess) != fileBytes)
  {
    return needed;
  }
  const auto& sides = guess.dimensions;
  return needed + "; its size fits --raw-dimensions " + std::to_string(sides[0]) + 'x' +
    std::to_string(sides[1]) + 'x' + std::to_string(sides[2]) + " --raw-type " + guess.type;
}

void RejectSeries(const VolumeArguments& arguments, const std::string& kind)
{
  if (!arguments.series.empty())
  {
    throw UsageError(
      "--series: expected a folder of DICOM files, found the " + kind + " " + arguments.input);
  }
}

std::optional<bool> RectifiedBy(const VolumeArguments& arguments)
{
  return arguments.rectify || arguments.asScanned ? std::optional<bool>(arguments.rectify)
                                                  : std::nullopt;
}

/// Applies a text such as "3", the number of a time, or "1.4s", its seconds.
void TakeTime(const std::string& text, FileSource& source)
{
  if (!text.empty() && text.back() == 's')
  {
    source.timeSeconds = NumberOf<double>(text.substr(0, text.size() - 1));
  }
  else if (!text.empty())
  {
    source.time = *NumberOf<int>(text);
    source.timeSeconds.reset();
  }
}

void RejectRectify(const VolumeArguments& arguments)
{
  if (const std::optional<bool> rectified = RectifiedBy(arguments))
  {
    throw UsageError(std::string(*rectified ? "--rectify" : "--as-scanned") +
      ": expected a scan, found a procedural volume");
  }
}

void RejectParts(const VolumeArguments& arguments)
{
  if (arguments.kind > 0)
  {
    throw UsageError("--kind: expected a DICOM series, found a procedural volume");
  }
  if (arguments.level || arguments.channel)
  {
    throw UsageError(std::string(arguments.level ? "--level" : "--channel") +
      ": expected a file with levels, found a procedural volume");
  }
}

void RejectTime(const VolumeArguments& arguments)
{
  if (!arguments.time.empty() || arguments.filesAreTimes)
  {
    throw UsageError(std::string(arguments.time.empty() ? "--files-are-times" : "--time") +
      ": expected a file, found a procedural volume");
  }
}

/// Says which of several times a user gets who has not chosen one.
void TellTime(const FileSource& source, const LoadedTimes& times)
{
  if (times.AreSeveral() && source.time == 0 && !source.timeSeconds)
  {
    PrintMessage("note: the file holds " + std::to_string(times.values.size()) +
      " times; the first was read, and --time chooses another");
  }
}

}

std::string TimeProblem(const std::string& text)
{
  const bool isSeconds = !text.empty() && text.back() == 's';
  const auto seconds = NumberOf<double>(text.substr(0, text.size() - (isSeconds ? 1 : 0)));
  const bool isTime =
    isSeconds ? seconds && std::isfinite(*seconds) : NumberOf<int>(text).value_or(-1) >= 0;
  return isTime ? ""
                : "expected the number of a time, counted from 0, or its seconds such as 1.4s, "
                  "found \"" +
      text + '"';
}

VolumeSource SourceOf(const VolumeArguments& arguments, const std::string& input)
{
  if (input.compare(0, ProceduralPrefix.size(), ProceduralPrefix) == 0)
  {
    RejectFileArguments(arguments, "procedural volume");
    RejectRectify(arguments);
    RejectParts(arguments);
    RejectTime(arguments);
    return ProceduralFromInput(input);
  }
  FileSource source = { input, std::nullopt };
  if (!MayHoldSeveralSeries(source))
  {
    RejectSeries(arguments, "file");
  }
  source.series = arguments.series;
  source.kind = arguments.kind;
  source.rectified = RectifiedBy(arguments);
  source.memoryMegabytes = arguments.memoryMegabytes;
  source.level = arguments.level;
  source.channel = arguments.channel;
  source.filesAreTimes = arguments.filesAreTimes;
  TakeTime(arguments.time, source);
  if (HasRawLayout(arguments))
  {
    source.raw = arguments.raw;
  }
  else if (IsBareVoxels(input) && std::filesystem::is_regular_file(input))
  {
    throw UsageError("--raw-dimensions: " + MissingDimensions(input));
  }
  return source;
}

void RejectFileArguments(const VolumeArguments& arguments, const std::string& kind)
{
  RejectSeries(arguments, kind);
  if (HasRawLayout(arguments))
  {
    throw UsageError(
      "--raw-dimensions: expected a raw file, found the " + kind + " " + arguments.input);
  }
}

VolumeSource Override(const VolumeArguments& arguments, const VolumeSource& volumeOfScene)
{
  VolumeSource source = volumeOfScene;
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    const std::optional<bool> rectified = RectifiedBy(arguments);
    file->rectified = rectified ? rectified : file->rectified;
    const double memory = arguments.memoryMegabytes;
    file->memoryMegabytes = memory > 0.0 ? memory : file->memoryMegabytes;
    file->level = arguments.level ? arguments.level : file->level;
    file->kind = arguments.kind > 0 ? arguments.kind : file->kind;
    file->channel = arguments.channel ? arguments.channel : file->channel;
    file->filesAreTimes = file->filesAreTimes || arguments.filesAreTimes;
    TakeTime(arguments.time, *file);
    return source;
  }
  RejectRectify(arguments);
  RejectParts(arguments);
  RejectTime(arguments);
  return source;
}

LoadedVolume LoadVolumeReporting(const VolumeSource& source, bool mayBePreview)
{
  const auto* file = std::get_if<FileSource>(&source);
  Progress progress(file ? "Reading " + file->path : "Computing the volume");
  const auto observe = [&](double part)
  {
    progress.SetPart(part);
    return true;
  };
  LoadedVolume volume = LoadVolume(source, observe, mayBePreview);
  for (const std::string& warning : volume.warnings)
  {
    PrintMessage("warning: " + warning);
  }
  if (file)
  {
    TellTime(*file, volume.times);
  }
  return volume;
}

}
