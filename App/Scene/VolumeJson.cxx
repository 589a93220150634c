#include "Scene/VolumeJson.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace varimarch
{

namespace
{

constexpr int LargestVolumeSide = 1 << 20;

const std::vector<std::string> fileKeys = { "file", "series", "kind", "rectified", "level",
  "channel", "raw", "memory", "time", "timeSeconds", "filesAreTimes" };
const std::vector<std::string> proceduralKeys = { "procedural", "size", "seed" };

RawLayout RawLayoutFromJson(const JsonCursor& json)
{
  json.RequireObject({ "dimensions", "type", "spacing", "byteOrder", "headerBytes" });
  RawLayout raw;
  raw.dimensions = json.At("dimensions").Integers<3>(1, LargestVolumeSide);
  json.At("type").Choice(RawTypeNames());
  raw.type = json.At("type").Text();
  if (const auto spacing = json.Find("spacing"))
  {
    raw.spacingMm = spacing->Numbers<3>(Positive);
  }
  if (const auto order = json.Find("byteOrder"))
  {
    raw.bigEndian = order->Choice(ByteOrderNames());
  }
  if (const auto header = json.Find("headerBytes"))
  {
    raw.headerBytes = header->Integer(0, std::numeric_limits<int>::max());
  }
  return raw;
}

/// Reads the keys that choose a time of a file, or files as times.
void ReadTimeKeys(const JsonCursor& json, FileSource& source)
{
  if (const auto time = json.Find("time"))
  {
    source.time = time->Integer(0, std::numeric_limits<int>::max());
  }
  if (const auto seconds = json.Find("timeSeconds"))
  {
    source.timeSeconds = seconds->Number();
  }
  if (const auto filesAreTimes = json.Find("filesAreTimes"))
  {
    source.filesAreTimes = filesAreTimes->Boolean();
  }
}

FileSource FileFromJson(const JsonCursor& json)
{
  json.RequireObject(fileKeys);
  FileSource source = { json.At("file").Text(), std::nullopt };
  if (const auto series = json.Find("series"))
  {
    source.series = series->Text();
  }
  if (const auto kind = json.Find("kind"))
  {
    source.kind = kind->Integer(1, LargestKind);
  }
  if (const auto rectified = json.Find("rectified"))
  {
    source.rectified = rectified->Boolean();
  }
  if (const auto level = json.Find("level"))
  {
    source.level = level->Integer(0, LargestLevel);
  }
  if (const auto channel = json.Find("channel"))
  {
    source.channel = channel->Integer(0, LargestChannel);
  }
  ReadTimeKeys(json, source);
  if (const auto raw = json.Find("raw"))
  {
    source.raw = RawLayoutFromJson(*raw);
  }
  if (const auto memory = json.Find("memory"))
  {
    source.memoryMegabytes = memory->Number(Positive);
  }
  return source;
}

}

VolumeSource VolumeFromJson(const JsonCursor& json)
{
  std::vector<std::string> allKeys = fileKeys;
  allKeys.insert(allKeys.end(), proceduralKeys.begin(), proceduralKeys.end());
  json.RequireObject(allKeys);
  if (json.Find("file"))
  {
    return FileFromJson(json);
  }
  if (!json.Find("procedural"))
  {
    json.Fail("expected the key \"file\" or \"procedural\", found neither");
  }
  json.RequireObject(proceduralKeys);
  ProceduralSource source;
  source.kind = json.At("procedural").Choice(ProceduralNames());
  if (const auto size = json.Find("size"))
  {
    source.dimensions = size->Integers<3>(2, LargestProceduralSide);
  }
  if (const auto seed = json.Find("seed"))
  {
    source.seed = seed->Integer(0, std::numeric_limits<int>::max());
  }
  return source;
}

namespace
{

void WritePart(const FileSource& file, nlohmann::ordered_json& json)
{
  if (file.level)
  {
    json["level"] = *file.level;
  }
  if (file.channel)
  {
    json["channel"] = *file.channel;
  }
  if (file.timeSeconds)
  {
    json["timeSeconds"] = *file.timeSeconds;
  }
  else if (file.time > 0)
  {
    json["time"] = file.time;
  }
  if (file.filesAreTimes)
  {
    json["filesAreTimes"] = true;
  }
}

nlohmann::ordered_json JsonFromFile(const FileSource& file)
{
  nlohmann::ordered_json json = { { "file", file.path } };
  if (!file.series.empty())
  {
    json["series"] = file.series;
  }
  if (file.kind > 0)
  {
    json["kind"] = file.kind;
  }
  if (file.rectified)
  {
    json["rectified"] = *file.rectified;
  }
  WritePart(file, json);
  if (file.raw)
  {
    json["raw"] = { { "dimensions", file.raw->dimensions }, { "type", file.raw->type },
      { "spacing", file.raw->spacingMm },
      { "byteOrder", NameOf(ByteOrderNames(), file.raw->bigEndian) },
      { "headerBytes", file.raw->headerBytes } };
  }
  if (file.memoryMegabytes > 0.0)
  {
    json["memory"] = file.memoryMegabytes;
  }
  return json;
}

}

nlohmann::ordered_json JsonFromVolume(const VolumeSource& volume)
{
  if (const auto* file = std::get_if<FileSource>(&volume))
  {
    return JsonFromFile(*file);
  }
  const auto& procedural = std::get<ProceduralSource>(volume);
  return { { "procedural", NameOf(ProceduralNames(), procedural.kind) },
    { "size", procedural.dimensions }, { "seed", procedural.seed } };
}

}
