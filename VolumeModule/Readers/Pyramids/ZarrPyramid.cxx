// OME-Zarr 0.1 to 0.4, and arrays of Zarr version 2 without that metadata. See
// https://ngff.openmicroscopy.org/0.4/
#include "Readers/FileError.h"
#include "Readers/Pyramids/ArrayAxes.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Pyramids/ZarrArray.h"
#include "Readers/VoxelLayout.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// An array of a group that the Python package xarray wrote, with the places that its coordinates
/// give to its axes. See https://docs.xarray.dev/en/stable/internals/zarr-encoding-spec.html
struct XarrayVariable
{
  std::string folder;
  ArrayAxes axes;
  std::vector<std::string> warnings;
};

/// The names of an array's axes in the attributes that xarray writes; empty texts if it has none.
std::vector<std::string> XarrayNames(const nlohmann::json& attributes, std::size_t rank);

namespace fs = std::filesystem;

nlohmann::json AttributesOf(const fs::path& folder)
{
  const fs::path path = folder / ZarrAttributesFile;
  return fs::exists(path) ? JsonObjectOf(path.string()) : nlohmann::json::object();
}

std::optional<double> NumberIn(const nlohmann::json& attributes, const char* key)
{
  const nlohmann::json& value = ValueAt(attributes, key);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// The size of the array in a folder; nothing if there is none that can be read.
std::optional<std::vector<std::int64_t>> ShapeIn(const fs::path& folder)
{
  try
  {
    return fs::exists(folder / ZarrArrayFile) ? std::optional(ReadZarrHeader(folder.string()).shape)
                                              : std::nullopt;
  }
  catch (const std::runtime_error&)
  {
    return std::nullopt; // texts and other values that are not numbers
  }
}

/// The values of an array with one axis.
std::vector<double> ValuesOf(const std::string& folder)
{
  const ZarrArray array(folder);
  const ZarrHeader& header = array.Header();
  const std::size_t valueBytes = header.fill.size();
  const std::int64_t count = header.shape.front();
  CheckedChunkBytes(folder, header.shape, std::int64_t(valueBytes + sizeof(double)));
  constexpr std::size_t None = ArraySelection::NoAxis;
  std::vector<char> bytes(std::size_t(count) * valueBytes);
  array.Read({ { 0, None, None }, { 0 } }, { { 0, 0, 0 }, { count, 1, 1 } }, bytes.data());
  std::vector<double> values;
  for (auto value = bytes.begin(); value != bytes.end(); value += std::ptrdiff_t(valueBytes))
  {
    values.push_back(ValueIn({ value, value + std::ptrdiff_t(valueBytes) }, header.scalarType));
  }
  return values;
}

/// Places an axis by its coordinates, the array of its name in a group.
/// @returns false if they do not say how long a step is
bool TakeCoordinates(
  const fs::path& group, std::int64_t count, ArrayAxis& axis, std::vector<std::string>& warnings)
{
  // A name that leads out of the group is that of no array in it.
  const fs::path folder = group / fs::path(axis.name).filename();
  const auto shape = ShapeIn(folder);
  const bool fits = shape && *shape == std::vector<std::int64_t>{ count };
  const std::vector<double> values = fits ? ValuesOf(folder.string()) : std::vector<double>();
  return PlaceAxis(values, TextIn(ValueAt(AttributesOf(folder), "units")), axis, warnings);
}

/// The arrays of at least three axes that xarray named, from the largest on.
std::vector<fs::path> VariablesIn(const fs::path& folder)
{
  std::vector<std::pair<double, fs::path>> found;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    const auto shape = ShapeIn(entry.path());
    if (!shape || shape->size() < 3 ||
      XarrayNames(AttributesOf(entry.path()), shape->size())[0].empty())
    {
      continue;
    }
    double count = 1.0;
    std::for_each(shape->begin(), shape->end(), [&](std::int64_t size) { count *= double(size); });
    found.emplace_back(-count, entry.path());
  }
  std::sort(found.begin(), found.end());
  std::vector<fs::path> folders;
  std::for_each(
    found.begin(), found.end(), [&](const auto& one) { folders.push_back(one.second); });
  return folders;
}

std::vector<std::string> XarrayNames(const nlohmann::json& attributes, std::size_t rank)
{
  std::vector<std::string> names;
  for (const nlohmann::json& name : ListIn(ValueAt(attributes, "_ARRAY_DIMENSIONS")))
  {
    names.push_back(TextIn(name));
  }
  return names.size() == rank ? names : std::vector<std::string>(rank);
}

/// The largest array of at least three axes in a group of xarray; nothing if the folder is another
/// one, or is an array itself.
/// @throws std::runtime_error if its coordinates cannot be read
std::optional<XarrayVariable> LargestXarrayVariable(const std::string& given)
{
  const fs::path folder = given;
  const std::vector<fs::path> all =
    fs::exists(folder / ZarrArrayFile) ? std::vector<fs::path>() : VariablesIn(folder);
  if (all.empty())
  {
    return std::nullopt;
  }
  XarrayVariable variable = { all.front().string(), {}, {} };
  const std::vector<std::int64_t> shape = ReadZarrHeader(variable.folder).shape;
  const nlohmann::json attributes = AttributesOf(all.front());
  variable.axes = AxesNamed(variable.folder, XarrayNames(attributes, shape.size()));
  WarnOfScale(
    NumberIn(attributes, "scale_factor"), NumberIn(attributes, "add_offset"), variable.warnings);
  bool areKnown = true;
  for (std::size_t i = 0; i < shape.size(); ++i)
  {
    ArrayAxis& axis = variable.axes[i];
    const bool isKnown = TakeCoordinates(folder, shape[i], axis, variable.warnings);
    areKnown = areKnown && (isKnown || !axis.world);
  }
  if (!areKnown)
  {
    variable.warnings.push_back(UnknownSpacing);
  }
  if (all.size() > 1)
  {
    variable.warnings.push_back("The folder holds " + std::to_string(all.size()) +
      " volumes; only the largest, " + Quoted(all.front().filename().string()) +
      ", was read (another is opened as the folder in it).");
  }
  return variable;
}

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
