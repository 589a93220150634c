// VTK's legacy files with structured points: lines of text, then the values as text or big-endian
// numbers. VTK's own reader does not report a file that ends early. See "VTK File Formats", Simple
// Legacy Formats.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelFile.h"

#include <map>

namespace varimarch
{
namespace
{

struct LegacyHeader
{
  bool isBinary = false;
  bool isInCells = false;
  std::vector<double> dimensions;
  std::vector<double> spacing = { 1.0, 1.0, 1.0 };
  std::vector<double> origin = { 0.0, 0.0, 0.0 };
  std::string type; ///< type of the first array
  std::int64_t componentCount = 1;
  std::uint64_t end = 0; ///< file offset of the values
};

int TypeOf(const std::string& path, const std::string& name)
{
  static const std::map<std::string, int> types = {
    { "char", VTK_SIGNED_CHAR },
    { "signed_char", VTK_SIGNED_CHAR },
    { "unsigned_char", VTK_UNSIGNED_CHAR },
    { "short", VTK_SHORT },
    { "unsigned_short", VTK_UNSIGNED_SHORT },
    { "int", VTK_INT },
    { "unsigned_int", VTK_UNSIGNED_INT },
    { "long", VTK_TYPE_INT64 },
    { "vtktypeint64", VTK_TYPE_INT64 },
    { "unsigned_long", VTK_TYPE_UINT64 },
    { "vtktypeuint64", VTK_TYPE_UINT64 },
    { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE },
  };
  const auto type = types.find(name);
  if (type == types.end())
  {
    FailToRead(path, "values of a type such as short or float", Quoted(name));
  }
  return type->second;
}

/// Takes a line about the grid.
void TakeGridLine(
  const std::string& path, const std::vector<std::string>& words, LegacyHeader& header)
{
  const std::string key = LowerCase(words[0]);
  const auto numbers = [&]
  {
    std::string line;
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      line += words[i] + ' ';
    }
    return NumbersFromText(path, key, line, 3);
  };
  if (key == "binary")
  {
    header.isBinary = true;
  }
  else if (key == "dimensions")
  {
    header.dimensions = numbers();
  }
  else if (key == "spacing" || key == "aspect_ratio")
  {
    header.spacing = numbers();
  }
  else if (key == "origin")
  {
    header.origin = numbers();
  }
  else if (key == "cell_data" || key == "point_data")
  {
    header.isInCells = key == "cell_data";
  }
}

/// Takes the first line of an array after POINT_DATA or CELL_DATA; returns false for other lines.
bool TakeArrayLine(
  const std::string& path, const std::vector<std::string>& words, LegacyHeader& header)
{
  static const std::map<std::string, int> componentCounts = { { "vectors", 3 }, { "normals", 3 },
    { "tensors", 9 }, { "tensors6", 6 } };
  const std::string key = LowerCase(words[0]);
  if (key == "scalars" && words.size() >= 3)
  {
    header.type = LowerCase(words[2]);
    header.componentCount =
      words.size() > 3 ? IntegerFromText(path, "a number of components", words[3]) : 1;
  }
  else if (key == "color_scalars" && words.size() == 3)
  {
    header.type = header.isBinary ? "unsigned_char" : "float";
    header.componentCount = IntegerFromText(path, "a number of components", words[2]);
  }
  else if (componentCounts.count(key) > 0 && words.size() == 3)
  {
    header.type = LowerCase(words[2]);
    header.componentCount = componentCounts.at(key);
  }
  return !header.type.empty();
}

/// Reads up to the values of the first array: that of SCALARS, VECTORS ... or of a field.
LegacyHeader ReadLegacyHeader(const std::string& path)
{
  LegacyHeader header;
  HeaderLines lines(path);
  bool isInData = false;
  bool isInField = false;
  while (header.type.empty())
  {
    const std::optional<std::string> line = lines.Next();
    if (!line)
    {
      FailToRead(path, "an array of point or cell data", "none");
    }
    const std::vector<std::string> words = Words(*line);
    if (words.empty())
    {
      continue;
    }
    const std::string key = LowerCase(words[0]);
    if (isInField && words.size() == 4)
    {
      header.componentCount = IntegerFromText(path, "a number of components", words[1]);
      header.type = LowerCase(words[3]);
    }
    else if (!isInData || !TakeArrayLine(path, words, header))
    {
      TakeGridLine(path, words, header);
    }
    isInData = isInData || key == "cell_data" || key == "point_data";
    isInField = isInData && key == "field";
  }
  header.end = lines.Position();
  // The name of a table of colours may come first.
  const std::vector<std::string> next = Words(lines.Next().value_or(""));
  header.end =
    !next.empty() && LowerCase(next[0]) == "lookup_table" ? lines.Position() : header.end;
  return header;
}

}

Volume ReadLegacyVtk(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const LegacyHeader header = ReadLegacyHeader(path);
  if (header.dimensions.empty())
  {
    FailToRead(path, "a line with DIMENSIONS", "none");
  }
  VoxelLayout layout = { {}, TypeOf(path, header.type), header.componentCount };
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Cells lie between points, and their voxels at their centres.
    const bool isBetween = header.isInCells && header.dimensions[std::size_t(axis)] > 1.0;
    layout.dimensions[std::size_t(axis)] =
      WholeNumber(header.dimensions[std::size_t(axis)]) - (isBetween ? 1 : 0);
    geometry.axesMm[axis][axis] = header.spacing[std::size_t(axis)];
    geometry.originMm[axis] = header.origin[std::size_t(axis)] +
      (isBetween ? 0.5 * header.spacing[std::size_t(axis)] : 0.0);
  }
  VoxelFile file;
  file.paths = { path };
  file.fileOffset = std::int64_t(header.end);
  file.bigEndian = true;
  file.encoding = header.isBinary ? VoxelEncoding::Binary : VoxelEncoding::Text;
  Volume volume;
  volume.image = ReadVoxels(file, layout, progress);
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
