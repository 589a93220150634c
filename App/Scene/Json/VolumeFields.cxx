#include "Scene/Json/SceneFields.h"

namespace varimarch
{

namespace
{

constexpr int LargestVolumeSide = 1 << 20;

const Fields<RawLayout>& RawFields()
{
  static const Fields<RawLayout> fields("raw",
    [](Fields<RawLayout>& list)
    {
      list.Require("dimensions", &RawLayout::dimensions, IntegersForm<3>(1, LargestVolumeSide),
        { "the number of voxels along each axis" });
      list.Require("type", &RawLayout::type, WordForm(NamesOf(RawTypeNames())),
        { "the type of voxels", "", nullptr,
          ": `uint8`, `int8`, `uint16`, `int16`, `uint32`, `int32`, `uint64`, `int64`, `float32`, "
          "`float64`" });
      list.Add(
        "spacing", &RawLayout::spacingMm, NumbersForm<3>(Positive), { "voxel spacing", "mm" });
      list.Add("byteOrder", &RawLayout::bigEndian, ChoiceForm(ByteOrderNames()),
        { "byte order: `little` or `big`" });
      list.Add("headerBytes", &RawLayout::headerBytes, IntegerForm<std::int64_t>(0),
        { "bytes to skip before the first voxel" });
    });
  return fields;
}

void AddPartFields(Fields<FileSource>& fields)
{
  fields
    .Add("series", &FileSource::series, TextForm(),
      { "the DICOM series to read, if a folder has several: its SeriesInstanceUID, an unambiguous "
        "beginning of that, or its number, counted from 1 in a list with the longest series first",
        "", "the first" })
    .OmitDefault();
  fields
    .Add("kind", &FileSource::kind, IntegerForm(1, LargestKind),
      { "the kind of volume in that series, if it holds several, such as echoes, b-values, views "
        "or "
        "stations: its number, counted from 1, in the list that `varimarch info` prints",
        "", "the first" })
    .OmitDefault();
  fields.Add("rectified", &FileSource::rectified, BooleanForm(),
    { "`true`: a DICOM series with tilted, unevenly spaced or missing slices is resampled on an "
      "even grid; `false`: as scanned",
      "",
      "resampled if slices would be drawn elsewhere than they were scanned and no gap is wider "
      "than "
      "four usual distances" });
  fields.Add("level", &FileSource::level, IntegerForm(0, LargestLevel),
    { "the level to read of OME-Zarr, Imaris or BigDataViewer, the finest of which is 0", "",
      "the finest that fits in half of the free memory or can be drawn from its chunks" });
  fields.Add("channel", &FileSource::channel, IntegerForm(0, LargestChannel),
    { "the channel to read of these formats, counted from 0", "",
      "all of two to four that fit in half of the free memory, else the first" });
}

void AddMemoryAndTimeFields(Fields<FileSource>& fields)
{
  fields.Add(
    "raw", &FileSource::raw, ObjectForm(&RawFields), { "the layout of a file without a header" });
  fields
    .Add("memory", &FileSource::memoryMegabytes, NumberForm(Positive),
      { "memory that the program may use [MB]: voxels that need more than a quarter of it are "
        "drawn "
        "from their file (`Formats.md`)",
        "", "all of the machine's" })
    .OmitDefault();
  fields
    .Add("time", &FileSource::time, IntegerForm(0),
      { "number of the time to draw of a file with [several](Formats.md#times), counted from 0", "",
        "0" })
    .OmitIf([](const FileSource& file) { return file.time == 0 || file.timeSeconds; });
  fields.Add("timeSeconds", &FileSource::timeSeconds, NumberForm(),
    { "instead of `time`: the time nearest to this one", "s" });
  fields
    .Add("filesAreTimes", &FileSource::filesAreTimes, BooleanForm(),
      { "`true`: the volumes in the folder `file`, or those beside it whose names differ from its "
        "own only in the last number before the first dot, are times",
        "", "`false`" })
    .OmitDefault();
}

const Fields<FileSource>& FileFields()
{
  static const Fields<FileSource> fields("file",
    [](Fields<FileSource>& list)
    {
      list.Require("file", &FileSource::path, TextForm(),
        { "a volume file or a folder with a DICOM series; a relative path starts at the scene's "
          "folder, and may lead out of it (`SECURITY.md` says what a scene may do)" });
      AddPartFields(list);
      AddMemoryAndTimeFields(list);
    });
  return fields;
}

const Fields<ProceduralSource>& ProceduralFields()
{
  static const Fields<ProceduralSource> fields("procedural",
    [](Fields<ProceduralSource>& list)
    {
      list.Require("procedural", &ProceduralSource::kind, ChoiceForm(ProceduralNames()),
        { "`shells`, `marschner-lobb`, `torso`, `checkerboard` or `ramp`: see "
          "`App/Scene/Volumes/ProceduralVolume.h`" });
      list.Add("size", &ProceduralSource::dimensions, IntegersForm<3>(2, LargestProceduralSide),
        { "voxels along each axis, 2 to 1024; the extent in mm stays" });
      list.Add("seed", &ProceduralSource::seed, IntegerForm<unsigned>(0),
        { "seed of the noise and of the lungs' vessels" });
    });
  return fields;
}

// Reads one of both kinds. A key of neither is an error that lists all keys.
void ReadVolume(const JsonCursor& json, VolumeSource& volume)
{
  std::vector<std::string> keys = FileFields().Keys();
  const std::vector<std::string> proceduralKeys = ProceduralFields().Keys();
  keys.insert(keys.end(), proceduralKeys.begin(), proceduralKeys.end());
  json.RequireObject(keys);
  if (json.Find("file"))
  {
    FileFields().Read(json, volume.emplace<FileSource>());
    return;
  }
  if (!json.Find("procedural"))
  {
    json.Fail("expected the key \"file\" or \"procedural\", found neither");
  }
  ProceduralFields().Read(json, volume.emplace<ProceduralSource>());
}

nlohmann::ordered_json WriteVolume(const VolumeSource& volume)
{
  const auto* const file = std::get_if<FileSource>(&volume);
  return file ? FileFields().Write(*file)
              : ProceduralFields().Write(std::get<ProceduralSource>(volume));
}

}

JsonForm<VolumeSource> VolumeForm()
{
  return NamedForm<VolumeSource>("volume",
    { &ReadVolume, &WriteVolume,
      [](FormatDescription& format)
      {
        return nlohmann::ordered_json{ { "oneOf",
          { FileFields().Describe(format), ProceduralFields().Describe(format) } } };
      } });
}

}
