// OME-Zarr 0.1 to 0.4, and arrays of Zarr version 2 without that metadata. See
// https://ngff.openmicroscopy.org/0.4/
#include "Readers/FileError.h"
#include "Readers/Pyramids/ArrayAxes.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Pyramids/XarrayGroup.h"
#include "Readers/Pyramids/ZarrArray.h"
#include "Readers/VoxelLayout.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

class ZarrPyramid : public VoxelPyramid
{
public:
  ZarrPyramid(const std::string& folder, const ReadOptions& options);

  std::int64_t Read(int level, const BrickSource::Box& box, void* voxels) override
  {
    return this->arrays[std::size_t(level)].Read(this->selections[std::size_t(level)], box, voxels);
  }

  StoredChunks Stored(int level) const override
  {
    const auto number = std::size_t(level);
    return this->arrays[number].Stored(
      this->selections[number], this->form.levels[number].dimensions);
  }

private:
  void AddMultiscale(const nlohmann::json& attributes);
  void AddArray(const nlohmann::json& attributes);
  void AddLevel(const std::string& folder, const ArrayAxes& axes);
  void TakeChannels(const nlohmann::json& attributes);
  void TakeWindow(const nlohmann::json& attributes);

  std::string folder;
  ReadOptions options; ///< only the channel and the time are used
  std::vector<ZarrArray> arrays;
  std::vector<ArraySelection> selections;
};

ZarrPyramid::ZarrPyramid(const std::string& folder, const ReadOptions& options)
  : folder(folder)
  , options(options)
{
  const std::string attributesPath = (fs::path(folder) / ZarrAttributesFile).string();
  const nlohmann::json attributes =
    fs::exists(attributesPath) ? JsonObjectOf(attributesPath) : nlohmann::json::object();
  if (!ListIn(ValueAt(attributes, "multiscales")).empty())
  {
    this->AddMultiscale(attributes);
    this->TakeChannels(attributes);
    this->TakeWindow(attributes);
  }
  else
  {
    this->AddArray(attributes);
  }
  SetScales(folder, this->form);
}

/// Adds an array whose axes xarray names, or nobody does; or the largest one of a group of xarray.
void ZarrPyramid::AddArray(const nlohmann::json& attributes)
{
  std::vector<std::string>& warnings = this->form.warnings;
  if (const std::optional<XarrayVariable> variable = LargestXarrayVariable(this->folder))
  {
    this->AddLevel(variable->folder, variable->axes);
    warnings.insert(warnings.end(), variable->warnings.begin(), variable->warnings.end());
  }
  else
  {
    const ZarrHeader header = ReadZarrHeader(this->folder);
    this->AddLevel(
      this->folder, AxesNamed(this->folder, XarrayNames(attributes, header.shape.size())));
    warnings.push_back(UnknownSpacing);
  }
  warnings.push_back(UnknownSides);
}

void ZarrPyramid::AddLevel(const std::string& levelFolder, const ArrayAxes& axes)
{
  const ZarrArray& array = this->arrays.emplace_back(levelFolder);
  const ZarrHeader& header = array.Header();
  this->selections.push_back(
    SelectionOf(levelFolder, axes, header.shape, header.isFortran, this->options));
  const ArraySelection& selection = this->selections.back();
  BrickSource::Level level = { { 1, 1, 1 }, { 1, 1, 1 }, { 1.0, 1.0, 1.0 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = selection.axes[axis];
    if (place != ArraySelection::NoAxis)
    {
      level.dimensions[axis] = header.shape[place];
      level.chunk[axis] = std::min(header.shape[place], header.chunk[place]);
    }
  }
  if (this->form.levels.empty())
  {
    this->form.scalarType = header.scalarType;
    DescribeAxes(axes, header.shape, this->options.channel, this->form);
  }
  if (header.scalarType != this->form.scalarType)
  {
    FailToRead(levelFolder,
      std::string("voxels of the type of the first level, ") +
        vtkImageScalarTypeNameMacro(this->form.scalarType),
      vtkImageScalarTypeNameMacro(header.scalarType));
  }
  this->form.levels.push_back(level);
  this->form.geometries.push_back(GeometryOf(axes, selection));
}

void ZarrPyramid::AddMultiscale(const nlohmann::json& attributes)
{
  const std::string path = (fs::path(this->folder) / ZarrAttributesFile).string();
  const std::vector<nlohmann::json> all = ListIn(ValueAt(attributes, "multiscales"));
  const nlohmann::json& multiscale = all.front();
  const std::vector<nlohmann::json> datasets = ListIn(ValueAt(multiscale, "datasets"));
  constexpr std::size_t MostLevels = 100;
  if (datasets.empty() || datasets.size() > MostLevels)
  {
    FailToRead(path, "1 to 100 datasets of a multiscale image", std::to_string(datasets.size()));
  }
  if (all.size() > 1)
  {
    this->form.warnings.push_back("The file holds " + std::to_string(all.size()) +
      " multiscale images; only the first was read.");
  }
  for (const nlohmann::json& dataset : datasets)
  {
    const fs::path inner = TextIn(ValueAt(dataset, "path"));
    const bool leadsOut = inner.empty() || inner.is_absolute() ||
      std::find(inner.begin(), inner.end(), "..") != inner.end();
    if (leadsOut)
    {
      FailToRead(
        path, "a path below its folder for each dataset", Quoted(ValueAt(dataset, "path").dump()));
    }
    ArrayAxes axes = OmeAxes(path, multiscale, this->form.warnings);
    ApplyTransforms(path, ValueAt(dataset, "coordinateTransformations"), axes);
    ApplyTransforms(path, ValueAt(multiscale, "coordinateTransformations"), axes);
    this->AddLevel((fs::path(this->folder) / inner).string(), axes);
  }
}

/// The colour of six hexadecimal digits; nothing for another text, and for white, which is no
/// colour of one among others.
std::optional<glm::dvec3> ColorOf(const std::string& digits)
{
  char* end = nullptr;
  const long rgb = std::strtol(digits.c_str(), &end, 16);
  if (digits.size() != 6 || *end != '\0' || rgb < 0 || rgb == 0xffffff)
  {
    return std::nullopt;
  }
  return glm::dvec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0;
}

/// Takes the names and the colours of the channels.
void ZarrPyramid::TakeChannels(const nlohmann::json& attributes)
{
  const auto channels = ListIn(ValueAt(ValueAt(attributes, "omero"), "channels"));
  for (std::size_t i = 0; i < std::min(channels.size(), this->form.channels.size()); ++i)
  {
    const std::string label = TextIn(ValueAt(channels[i], "label"));
    VolumeChannel& channel = this->form.channels[i];
    channel.name = label.empty() ? channel.name : label;
    channel.rgb = ColorOf(TextIn(ValueAt(channels[i], "color")));
  }
}

/// Takes the range of values that the file recommends for the channel.
void ZarrPyramid::TakeWindow(const nlohmann::json& attributes)
{
  const auto channels = ListIn(ValueAt(ValueAt(attributes, "omero"), "channels"));
  const auto channel = std::size_t(this->options.channel);
  if (channel >= channels.size())
  {
    return;
  }
  const nlohmann::json& window = ValueAt(channels[channel], "window");
  const nlohmann::json& start = ValueAt(window, "start");
  const nlohmann::json& end = ValueAt(window, "end");
  if (start.is_number() && end.is_number() && end.get<double>() > start.get<double>())
  {
    const double from = start.get<double>();
    const double to = end.get<double>();
    this->form.windowLevel = { to - from, 0.5 * (from + to) };
  }
}

/// The folder of the image that a path means: that of a file in it, or the first of several images
/// as bioformats2raw writes them.
std::string ImageFolder(const std::string& path, std::vector<std::string>& warnings)
{
  fs::path folder = fs::is_directory(path) ? fs::path(path) : fs::path(path).parent_path();
  folder = folder.empty() ? fs::path(".") : folder;
  const std::string attributes = (folder / ZarrAttributesFile).string();
  const bool holdsSeries = fs::exists(attributes) &&
    !ValueAt(JsonObjectOf(attributes), "bioformats2raw.layout").is_null() &&
    fs::exists(folder / "0" / ZarrAttributesFile);
  if (!holdsSeries)
  {
    return folder.string();
  }
  if (fs::exists(folder / "1" / ZarrAttributesFile))
  {
    warnings.push_back(
      "The folder holds several images, in folders that are numbers; only that in 0 was read.");
  }
  return (folder / "0").string();
}

/// Fails with a sentence about a folder of Zarr that holds no single volume.
void CheckHoldsVolume(const std::string& folder)
{
  const fs::path place = folder;
  const bool hasArray = fs::exists(place / ZarrArrayFile) || LargestXarrayVariable(folder);
  if (!hasArray && fs::exists(place / ZarrOfVersion3))
  {
    FailToRead(folder, "Zarr of version 2, as in OME-Zarr 0.4 (other programs convert to it)",
      "version 3 (" + std::string(ZarrOfVersion3) + ")");
  }
  const fs::path attributes = place / ZarrAttributesFile;
  const bool isImage =
    fs::exists(attributes) && ValueAt(JsonObjectOf(attributes.string()), "multiscales").is_array();
  if (!hasArray && !isImage)
  {
    std::string inner;
    for (const auto& entry : fs::directory_iterator(place))
    {
      const bool isNode =
        fs::exists(entry.path() / ZarrArrayFile) || fs::exists(entry.path() / ZarrGroupFile);
      inner += isNode && inner.size() < 80
        ? (inner.empty() ? "" : ", ") + Quoted(entry.path().filename().string())
        : "";
    }
    FailToRead(folder, "an array of Zarr, or the multiscales of OME-Zarr",
      inner.empty() ? "neither" : "a group with other nodes (open one of them): " + inner);
  }
}

}

std::unique_ptr<VoxelPyramid> OpenZarr(const std::string& path, const ReadOptions& options)
{
  try
  {
    std::vector<std::string> warnings;
    const std::string folder = ImageFolder(path, warnings);
    CheckHoldsVolume(folder);
    auto pyramid = std::make_unique<ZarrPyramid>(folder, options);
    pyramid->Warn(warnings);
    return pyramid;
  }
  catch (const fs::filesystem_error& error)
  {
    FailToRead(path, "a folder that can be read", error.code().message());
  }
}

}
