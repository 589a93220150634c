#include "Readers/Pyramids/XarrayGroup.h"

#include "Readers/FileError.h"
#include "Readers/Pyramids/ZarrArray.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{
namespace
{

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

}
