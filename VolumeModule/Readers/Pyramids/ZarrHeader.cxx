#include "Readers/Pyramids/ZarrHeader.h"

#include "Readers/FileError.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkSetGet.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <regex>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostAxes = 16;

/// Sizes along each axis.
std::vector<std::int64_t> SizesIn(
  const std::string& path, const nlohmann::json& header, const char* key)
{
  std::vector<std::int64_t> sizes;
  for (const nlohmann::json& size : ListIn(ValueAt(header, key)))
  {
    const bool isSize = size.is_number_integer() &&
      (!size.is_number_unsigned() ||
        size.get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<std::int64_t>::max()));
    sizes.push_back(isSize ? size.get<std::int64_t>() : 0);
  }
  const bool areSizes =
    std::all_of(sizes.begin(), sizes.end(), [](std::int64_t size) { return size > 0; });
  if (sizes.empty() || sizes.size() > MostAxes || !areSizes)
  {
    FailToRead(path, std::string("whole numbers above 0 for 1 to 16 axes as ") + key,
      Quoted(ValueAt(header, key).dump()));
  }
  return sizes;
}

/// Takes the type of numbers, such as "<u2".
void TakeType(const std::string& path, const nlohmann::json& json, ZarrHeader& header)
{
  static const std::regex form("([<>|])([biuf])([1248])");
  const std::string text = TextIn(json);
  std::smatch parts;
  constexpr std::size_t longest = 3;
  if (text.size() == longest && std::regex_match(text, parts, form))
  {
    const char kind = *parts[2].first;
    const NumberKind numbers = kind == 'i' ? NumberKind::Signed
      : kind == 'f'                        ? NumberKind::Float
                                           : NumberKind::Unsigned;
    header.isBigEndian = parts[1] == ">";
    header.scalarType = ScalarTypeOf(numbers, std::stoi(parts[3]));
  }
  if (header.scalarType == VTK_VOID)
  {
    FailToRead(path,
      "integers of 8 to 64 bits or floats of 32 or 64 bits as dtype, such as \"<u2\"",
      Quoted(json.dump()));
  }
}

/// A number as bytes of its type.
template <class Number>
std::vector<char> BytesOf(Number number)
{
  std::vector<char> bytes(sizeof(number));
  std::memcpy(bytes.data(), &number, sizeof(number));
  return bytes;
}

/// A fill value as bytes of a type; empty if the type cannot hold it.
template <class Number>
std::vector<char> FillOf(const nlohmann::json& json)
{
  using Limits = std::numeric_limits<Number>;
  if constexpr (Limits::is_integer)
  {
    if (json.is_number_unsigned())
    {
      const auto number = json.get<std::uint64_t>();
      return number <= std::uint64_t(Limits::max()) ? BytesOf(Number(number)) : std::vector<char>();
    }
    if (json.is_number_integer())
    {
      const auto number = json.get<std::int64_t>();
      const bool fits = Limits::is_signed && number >= std::int64_t(Limits::min());
      return fits ? BytesOf(Number(number)) : std::vector<char>();
    }
    // Some writers give whole numbers a fraction of 0.
    const double number = json.is_number() ? json.get<double>() : 0.5;
    const bool fits = std::trunc(number) == number && number >= double(Limits::lowest()) &&
      number < std::ldexp(1.0, Limits::digits);
    return fits ? BytesOf(Number(number)) : std::vector<char>();
  }
  else
  {
    const std::string text = TextIn(json);
    const double number = text == "NaN" ? std::numeric_limits<double>::quiet_NaN()
      : text == "Infinity"              ? std::numeric_limits<double>::infinity()
                                        : -std::numeric_limits<double>::infinity();
    const bool isNumber = json.is_number();
    const bool isName = text == "NaN" || text == "Infinity" || text == "-Infinity";
    return isNumber ? BytesOf(Number(json.get<double>()))
      : isName      ? BytesOf(Number(number))
                    : std::vector<char>();
  }
}

void TakeFill(const std::string& path, const nlohmann::json& json, ZarrHeader& header)
{
  // Without a value voxels are undefined; zero is the usual choice.
  const nlohmann::json value = json.is_null() ? nlohmann::json(0)
    : json.is_boolean()                       ? nlohmann::json(json.get<bool>() ? 1 : 0)
                                              : json;
  switch (header.scalarType)
  {
    vtkTemplateMacro(header.fill = FillOf<VTK_TT>(value));
  }
  if (header.fill.empty())
  {
    FailToRead(path,
      std::string("a fill_value of the type ") + vtkImageScalarTypeNameMacro(header.scalarType),
      Quoted(json.dump()));
  }
}

/// Takes the compression, and refuses filters.
void TakeCodec(const std::string& path, const nlohmann::json& json, ZarrHeader& header)
{
  std::string filters;
  for (const nlohmann::json& filter : ListIn(ValueAt(json, "filters")))
  {
    filters += (filters.empty() ? "" : ", ") + Quoted(TextIn(ValueAt(filter, "id")));
  }
  if (!filters.empty())
  {
    FailToRead(path, "chunks without filters (write the array anew with filters=None)",
      "the filters " + filters);
  }
  const nlohmann::json& compressor = ValueAt(json, "compressor");
  header.codec = TextIn(ValueAt(compressor, "id"));
  const std::vector<std::string> known = { "blosc", "bz2", "gzip", "lz4", "lzma", "zlib", "zstd" };
  const bool isKnown =
    compressor.is_null() || std::find(known.begin(), known.end(), header.codec) != known.end();
  if (!isKnown)
  {
    FailToRead(path, "the compressor null, blosc, bz2, gzip, lz4, lzma, zlib or zstd",
      Quoted(compressor.dump()));
  }
}

}

ZarrHeader ReadZarrHeader(const std::string& folder)
{
  const std::string path = (fs::path(folder) / ZarrArrayFile).string();
  const nlohmann::json json = JsonObjectOf(path);
  const nlohmann::json& format = ValueAt(json, "zarr_format");
  if (format != 2)
  {
    FailToRead(path, "Zarr of version 2", "the zarr_format " + Quoted(format.dump()));
  }
  ZarrHeader header;
  header.shape = SizesIn(path, json, "shape");
  header.chunk = SizesIn(path, json, "chunks");
  if (header.chunk.size() != header.shape.size())
  {
    FailToRead(path, "chunks of " + std::to_string(header.shape.size()) + " axes",
      std::to_string(header.chunk.size()));
  }
  TakeType(path, ValueAt(json, "dtype"), header);
  TakeFill(path, ValueAt(json, "fill_value"), header);
  CheckedChunkBytes(path, header.chunk, std::int64_t(header.fill.size()));
  TakeCodec(path, json, header);
  const std::string order = TextIn(ValueAt(json, "order"));
  if (order != "C" && order != "F")
  {
    FailToRead(path, "the order \"C\" or \"F\"", Quoted(ValueAt(json, "order").dump()));
  }
  header.isFortran = order == "F";
  const nlohmann::json& separator = ValueAt(json, "dimension_separator");
  header.separator = separator.is_null() ? "." : TextIn(separator);
  if (header.separator != "." && header.separator != "/")
  {
    FailToRead(path, R"(the dimension_separator "." or "/")", Quoted(separator.dump()));
  }
  return header;
}

}
