// GIPL, the Guy's Image Processing Lab format: a big-endian header of 256 bytes, then the voxels.
// The fields are those of ITK's itkGiplImageIO.cxx.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <map>

namespace varimarch
{
namespace
{

constexpr std::size_t giplHeaderBytes = 256;

bool HasMark(const BinaryHeader& header)
{
  const auto mark = header.At<unsigned int>(252);
  return mark == 719555000u || mark == 4026526128u || mark == 2968510904u;
}

int TypeOf(const std::string& path, const BinaryHeader& header)
{
  static const std::map<int, int> types = { { 1, VTK_UNSIGNED_CHAR }, { 7, VTK_SIGNED_CHAR },
    { 8, VTK_UNSIGNED_CHAR }, { 15, VTK_SHORT }, { 16, VTK_UNSIGNED_SHORT },
    { 31, VTK_UNSIGNED_INT }, { 32, VTK_INT }, { 64, VTK_FLOAT }, { 65, VTK_DOUBLE } };
  const int code = header.At<unsigned short>(8);
  const auto type = types.find(code);
  if (type == types.end())
  {
    FailToRead(path, "a GIPL type of real numbers, such as 15 or 64", std::to_string(code));
  }
  return type->second;
}

}

bool IsGipl(const std::string& head)
{
  return HasMark(BinaryHeader(head, true));
}

Volume ReadGipl(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const BinaryHeader header(path, giplHeaderBytes, true);
  if (!HasMark(header))
  {
    FailToRead(path, "a GIPL header that ends with its mark", "another end");
  }
  VoxelLayout layout = { {}, TypeOf(path, header) };
  ImageGeometry geometry;
  geometry.originMm = header.VectorAt<double>(204);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    layout.dimensions[axis] = header.At<unsigned short>(2 * axis);
    geometry.axesMm[int(axis)] *= double(header.At<float>(10 + 4 * axis));
  }
  VoxelFile file;
  file.paths = { path };
  file.compression = CompressionOf(path);
  file.bigEndian = true;
  file.dataOffset = giplHeaderBytes;

  Volume volume;
  TakeTimes(path, NumberedTimes(header.At<unsigned short>(6)), options, volume);
  file.volume = options.time;
  file.kept = StreamOf(options);
  volume.image = ReadVoxels(file, layout, progress);
  PlaceImage(path, geometry, volume.image);
  volume.warnings.push_back(UnknownSides);
  return volume;
}

}
