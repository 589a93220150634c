#include "VolumeOptions.h"

#include "Scene/RawGuess.h"
#include "Scene/SceneNames.h"
#include "Scene/VolumeLoading.h"
#include "Validators.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace varimarch
{

namespace
{

constexpr int LargestVolumeSide = 1 << 20;
const std::string ProceduralPrefix = "procedural:";

// "procedural:torso" or "procedural:torso:128x128x64"
ProceduralSource ProceduralFromInput(const std::string& input)
{
  const std::string rest = input.substr(ProceduralPrefix.size());
  const std::size_t colon = rest.find(':');
  const std::string name = rest.substr(0, colon);
  const std::string error = NameValidator(NamesOf(ProceduralNames()))(name);
  if (!error.empty())
  {
    throw CLI::ValidationError("VOLUME", error);
  }
  ProceduralSource source;
  source.kind = ValueOf(ProceduralNames(), name);
  if (colon != std::string::npos)
  {
    const std::string size = rest.substr(colon + 1);
    const auto validator = SidesValidator<3>("128x128x64", 2, LargestProceduralSide);
    const std::string sizeError = validator(size);
    if (!sizeError.empty())
    {
      throw CLI::ValidationError("VOLUME", sizeError);
    }
    source.dimensions = *Sides<3>(size, 2, LargestProceduralSide);
  }
  return source;
}

// Of bare voxels that come without their dimensions: what they may be.
std::string WithoutDimensions(const std::string& path)
{
  const std::string needed = "needed for the bare voxels of " + path;
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

}

void VolumeOptions::AddTo(CLI::App& command, const std::string& inputDescription)
{
  command.add_option("VOLUME", this->input, inputDescription)->required();
  command
    .add_option("--series", this->series,
      "Of several DICOM series: a number in the list of them that is shown\n"
      "without this, a SeriesInstanceUID, or the beginning of just one (default 1)")
    ->type_name("SERIES");
  command.add_flag(
    "--rectify", this->rectify, "Resample slices that were tilted or lie unevenly on an even grid");
  const std::string group = "Raw files (no header)";
  CLI::Option* dimensions =
    command.add_option("--raw-dimensions", this->rawDimensions, "Voxels along each axis")
      ->check(SidesValidator<3>("256x256x128", 1, LargestVolumeSide))
      ->type_name("XxYxZ")
      ->group(group);
  command.add_option("--raw-type", this->rawType, "Type of a voxel (default uint8)")
    ->check(NameValidator(NamesOf(RawTypeNames())))
    ->needs(dimensions)
    ->group(group);
  command
    .add_option("--raw-spacing", this->rawSpacing, "Distances of voxels in mm (default 1,1,1)")
    ->check(Above(0.0))
    ->delimiter(',')
    ->expected(3)
    ->type_name("X,Y,Z")
    ->needs(dimensions)
    ->group(group);
  command.add_option("--raw-byte-order", this->rawByteOrder, "Order of bytes (default little)")
    ->check(NameValidator(NamesOf(ByteOrderNames())))
    ->needs(dimensions)
    ->group(group);
  command
    .add_option("--raw-header-bytes", this->rawHeaderBytes,
      "Bytes to skip before the first voxel (default 0)")
    ->check(CLI::Range(std::int64_t(0), std::numeric_limits<std::int64_t>::max()).description(""))
    ->type_name("N")
    ->needs(dimensions)
    ->group(group);
}

void VolumeOptions::RefuseSeries(const std::string& kind) const
{
  if (!this->series.empty())
  {
    throw CLI::ValidationError(
      "--series", "expected a folder of DICOM files, found the " + kind + " " + this->input);
  }
}

void VolumeOptions::RefuseRectify() const
{
  if (this->rectify)
  {
    throw CLI::ValidationError("--rectify", "expected a scan, found a procedural volume");
  }
}

void VolumeOptions::RefuseFileOptions(const std::string& kind) const
{
  this->RefuseSeries(kind);
  if (!this->rawDimensions.empty())
  {
    throw CLI::ValidationError(
      "--raw-dimensions", "expected a raw file, found the " + kind + " " + this->input);
  }
}

VolumeSource VolumeOptions::SourceOf(const std::string& anyInput) const
{
  if (anyInput.compare(0, ProceduralPrefix.size(), ProceduralPrefix) == 0)
  {
    this->RefuseFileOptions("procedural volume");
    this->RefuseRectify();
    return ProceduralFromInput(anyInput);
  }
  FileSource source = { anyInput, std::nullopt };
  if (!MayHoldSeveralSeries(source))
  {
    this->RefuseSeries("file");
  }
  source.series = this->series;
  source.rectified = this->rectify;
  if (this->rawDimensions.empty() && IsBareVoxels(anyInput) &&
    std::filesystem::is_regular_file(anyInput))
  {
    throw CLI::ValidationError("--raw-dimensions", WithoutDimensions(anyInput));
  }
  if (!this->rawDimensions.empty())
  {
    RawLayout raw;
    raw.dimensions = *Sides<3>(this->rawDimensions, 1, LargestVolumeSide);
    raw.type = this->rawType.empty() ? raw.type : this->rawType;
    if (!this->rawSpacing.empty())
    {
      std::copy(this->rawSpacing.begin(), this->rawSpacing.end(), raw.spacingMm.begin());
    }
    raw.bigEndian = !this->rawByteOrder.empty() && ValueOf(ByteOrderNames(), this->rawByteOrder);
    raw.headerBytes = this->rawHeaderBytes;
    source.raw = raw;
  }
  return source;
}

VolumeSource VolumeOptions::Override(const VolumeSource& inScene) const
{
  VolumeSource source = inScene;
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    file->rectified = file->rectified || this->rectify;
    return source;
  }
  this->RefuseRectify();
  return source;
}

}
