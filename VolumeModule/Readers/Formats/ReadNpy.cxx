// NumPy arrays: a file with one array (.npy). See
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <regex>

namespace varimarch
{
namespace
{

constexpr const char* npyMark = "\x93NUMPY";
constexpr std::size_t npyMarkBytes = 6;

struct NpyHeader
{
  int scalarType;
  bool bigEndian;
  bool isFortran; ///< true if the first index runs fastest in the file
  std::vector<std::int64_t> shape;
  std::int64_t bytes; ///< length of the header
};

/// The text of the header: a Python dictionary.
std::string HeaderText(const std::string& path, std::int64_t& headerBytes)
{
  const auto stream = OpenStream(path, CompressionOf(path));
  unsigned char begin[12] = {};
  const std::size_t got = stream->Read(begin, 10);
  if (got < 10 ||
    !std::equal(begin, begin + npyMarkBytes, reinterpret_cast<const unsigned char*>(npyMark)))
  {
    FailToRead(path, "a NumPy array", "a file without its mark");
  }
  // Version 1 has two bytes for the length, later versions have four.
  const std::size_t lengthBytes = begin[6] == 1 ? 2 : 4;
  stream->Read(begin + 10, lengthBytes - 2);
  const std::size_t length = begin[8] + 256u * begin[9] +
    (lengthBytes == 4 ? 65536u * begin[10] + 16777216u * begin[11] : 0u);
  headerBytes = std::int64_t(8 + lengthBytes + length);
  constexpr std::size_t mostBytes = 1 << 16;
  std::string text(std::min(length, mostBytes), '\0');
  if (stream->Read(text.data(), text.size()) < length)
  {
    FailToRead(path, "a header of " + std::to_string(length) + " bytes", "fewer");
  }
  // std::regex recurses for each character, so a long text would exhaust the stack.
  constexpr std::size_t longestText = 1000;
  const std::string withoutPadding = Trimmed(text);
  if (withoutPadding.size() > longestText)
  {
    FailToRead(
      path, "a NumPy header of at most 1000 characters", std::to_string(withoutPadding.size()));
  }
  return withoutPadding;
}

NpyHeader ReadNpyHeader(const std::string& path)
{
  NpyHeader header = {};
  const std::string text = HeaderText(path, header.bytes);
  static const std::regex description(R"('descr':\s*'([<>|=])([a-z])(\d+)')");
  static const std::regex order(R"('fortran_order':\s*(True|False))");
  static const std::regex shape(R"('shape':\s*\(([\d,\s]*)\))");
  std::smatch type;
  std::smatch isFortran;
  std::smatch sizes;
  if (!std::regex_search(text, type, description) || !std::regex_search(text, isFortran, order) ||
    !std::regex_search(text, sizes, shape))
  {
    FailToRead(path, "a NumPy header with descr, fortran_order and shape", Quoted(text, 80));
  }
  const char kind = *type[2].first;
  const NumberKind numbers = kind == 'i' ? NumberKind::Signed
    : kind == 'f'                        ? NumberKind::Float
                                         : NumberKind::Unsigned;
  const std::int64_t valueBytes = IntegerFromText(path, "a size of numbers", type[3]);
  const bool isNumber = kind == 'i' || kind == 'u' || kind == 'f' || kind == 'b';
  header.scalarType = isNumber ? ScalarTypeOf(numbers, valueBytes) : VTK_VOID;
  if (header.scalarType == VTK_VOID)
  {
    FailToRead(path, "integers of 8 to 64 bits or floats of 32 or 64 bits",
      "the type " + Quoted(type[2].str() + type[3].str()));
  }
  header.bigEndian = type[1] == ">";
  header.isFortran = isFortran[1] == "True";
  std::string list = sizes[1];
  std::replace(list.begin(), list.end(), ',', ' ');
  for (const std::string& word : Words(list))
  {
    header.shape.push_back(IntegerFromText(path, "whole numbers as shape", word));
  }
  return header;
}

/// The roles of the array's indices.
struct NpyAxes
{
  bool hasComponents;     ///< true if the last index counts components
  std::size_t volumeAxes; ///< number of leading indices that count volumes
};

NpyAxes AxesOf(const std::string& path, const NpyHeader& header)
{
  const std::size_t rank = header.shape.size();
  double count = 1.0;
  for (const std::int64_t size : header.shape)
  {
    count *= double(size);
  }
  if (rank < 2 || rank > 16 || !(count >= 1.0 && count < 9e15))
  {
    FailToRead(path, "an array [z, y, x], perhaps with components as the last index",
      "an array of " + std::to_string(rank) + " dimensions and " + std::to_string(count) +
        " values");
  }
  const bool hasComponents = rank >= 4 && header.shape.back() <= 4;
  return { hasComponents, std::max<std::size_t>(rank - (hasComponents ? 1 : 0), 3) - 3 };
}

struct NpyGrid
{
  VoxelLayout layout;
  ImageGeometry geometry;
};

NpyGrid GridOf(const NpyHeader& header, const NpyAxes& axes)
{
  NpyGrid grid = { { { 1, 1, 1 }, header.scalarType, axes.hasComponents ? header.shape.back() : 1 },
    {} };
  const std::size_t end = header.shape.size() - (axes.hasComponents ? 1 : 0);
  const std::size_t count = end - axes.volumeAxes;
  for (std::size_t i = 0; i < count; ++i)
  {
    // The last index is x, and runs fastest; in Fortran's order the first index does.
    const std::size_t world = count - 1 - i;
    const std::size_t stored = header.isFortran ? i : world;
    grid.layout.dimensions[stored] = header.shape[axes.volumeAxes + i];
    grid.geometry.axesMm[int(stored)] = glm::dvec3(0.0);
    grid.geometry.axesMm[int(stored)][int(world)] = 1.0;
  }
  return grid;
}

}

bool IsNpy(const std::string& head)
{
  return head.compare(0, npyMarkBytes, npyMark) == 0;
}

Volume ReadNpy(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  ReadableFileSize(path);
  const NpyHeader header = ReadNpyHeader(path);
  const NpyAxes axes = AxesOf(path, header);
  const NpyGrid grid = GridOf(header, axes);
  VoxelFile file;
  file.paths = { path };
  file.compression = CompressionOf(path);
  file.bigEndian = header.bigEndian;
  file.dataOffset = header.bytes;
  file.planar = axes.hasComponents && header.isFortran;
  for (std::size_t i = 0; i < axes.volumeAxes; ++i)
  {
    file.volumeCount *= header.shape[i];
  }
  file.alternation = header.isFortran && file.volumeCount > 1 ? 1 : 0;

  Volume volume;
  TakeTimes(path, NumberedTimes(file.volumeCount), options, volume);
  file.volume = options.time;
  file.kept = StreamOf(options);
  volume.image = ReadVoxels(file, grid.layout, progress);
  PlaceImage(path, grid.geometry, volume.image);
  volume.warnings.push_back(UnknownSpacing);
  return volume;
}

}
