// MGH and MGZ, the format of FreeSurfer: a big-endian header of 284 bytes, then the voxels; MGZ is
// gzipped. See https://surfer.nmr.mgh.harvard.edu/fswiki/FsTutorial/MghFormat
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <map>
#include <optional>

namespace varimarch
{
namespace
{

constexpr std::size_t mghHeaderBytes = 284;

/// The VTK type of a type code.
std::optional<int> TypeOfCode(int code)
{
  static const std::map<int, int> types = { { 0, VTK_UNSIGNED_CHAR }, { 1, VTK_INT },
    { 3, VTK_FLOAT }, { 4, VTK_SHORT }, { 10, VTK_UNSIGNED_SHORT } };
  const auto type = types.find(code);
  return type == types.end() ? std::nullopt : std::optional(type->second);
}

/// Geometry in RAS: the header has the position of the volume's centre.
ImageGeometry GeometryOf(const BinaryHeader& header, const VoxelLayout& layout)
{
  ImageGeometry geometry;
  const glm::dvec3 spacingMm = header.VectorAt<float>(30);
  glm::dvec3 half;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = header.VectorAt<float>(42 + 12 * std::size_t(axis)) * spacingMm[axis];
    half[axis] = 0.5 * double(layout.dimensions[std::size_t(axis)]);
  }
  geometry.originMm = header.VectorAt<float>(78) - geometry.axesMm * half;
  return geometry;
}

/// The geometry, in RAS, that the format defines for headers without one: coronal slices of 1 mm
/// around the centre.
ImageGeometry DefaultGeometry(const VoxelLayout& layout)
{
  ImageGeometry geometry;
  geometry.axesMm = { { -1.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 0.0, 1.0, 0.0 } };
  geometry.originMm = geometry.axesMm *
    glm::dvec3(-0.5 * double(layout.dimensions[0]), -0.5 * double(layout.dimensions[1]),
      -0.5 * double(layout.dimensions[2]));
  return geometry;
}

/// The time from one volume to the next, which stands behind the voxels; 0 if it does not.
double RepetitionSeconds(const VoxelFile& file, const VoxelLayout& layout, int volumeCount)
{
  if (volumeCount < 2)
  {
    return 0.0;
  }
  const std::string& path = file.paths.front();
  const std::uint64_t end =
    mghHeaderBytes + CheckedByteCount(path, layout) * std::uint64_t(volumeCount);
  const bool isPlain = file.compression == Compression::None;
  const auto stream = OpenStream(path, file.compression, isPlain ? end : 0);
  stream->Skip(isPlain ? 0 : end);
  std::string bytes(sizeof(float), '\0');
  const bool isThere = stream->Read(bytes.data(), bytes.size()) == bytes.size();
  constexpr double SecondsPerMs = 1e-3;
  return isThere ? SecondsPerMs * double(BinaryHeader(bytes, true).At<float>(0)) : 0.0;
}

}

bool IsMgh(const std::string& head)
{
  const BinaryHeader header(head, true);
  const auto isLength = [&](std::size_t offset)
  { return header.At<int>(offset) > 0 && header.At<int>(offset) < (1 << 24); };
  return header.At<int>(0) == 1 && isLength(4) && isLength(8) && isLength(12) && isLength(16) &&
    TypeOfCode(header.At<int>(20)).has_value();
}

Volume ReadMgh(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const BinaryHeader header(path, mghHeaderBytes, true);
  const int version = header.At<int>(0);
  if (version != 1)
  {
    FailToRead(path, "an MGH header of version 1", "version " + std::to_string(version));
  }
  const int code = header.At<int>(20);
  const std::optional<int> type = TypeOfCode(code);
  if (!type)
  {
    FailToRead(path, "an MGH type: 0, 1, 3, 4 or 10", std::to_string(code));
  }
  const VoxelLayout layout = { { header.At<int>(4), header.At<int>(8), header.At<int>(12) },
    *type };
  VoxelFile file;
  file.paths = { path };
  file.compression = CompressionOf(path);
  file.bigEndian = true;
  file.dataOffset = mghHeaderBytes;

  Volume volume;
  const int volumeCount = header.At<int>(16);
  KeptInput once;
  std::optional<double>& repetition = (options.kept ? *options.kept : once).repetitionSeconds;
  repetition = repetition ? *repetition : RepetitionSeconds(file, layout, volumeCount);
  TakeTimes(path, EvenTimes(volumeCount, 0.0, *repetition), options, volume);
  file.volume = options.time;
  file.kept = StreamOf(options);
  const bool hasGeometry = header.At<short>(28) != 0;
  if (!hasGeometry)
  {
    volume.warnings.push_back(UnknownSides);
  }
  volume.image = ReadVoxels(file, layout, progress);
  const ImageGeometry geometry = hasGeometry ? GeometryOf(header, layout) : DefaultGeometry(layout);
  PlaceImage(path, InLps(geometry, LpsFromRas, 1.0), volume.image);
  return volume;
}

}
