// PVM, the format of the V^3 volume renderer: a text header and the voxels, usually compressed as a
// whole. See the appendix of its documentation, http://www.stereofx.org/volume.html
#include "Readers/DifferentialStream.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/HeaderText.h"
#include "Readers/ImageGeometry.h"
#include "Readers/VoxelFile.h"

#include <algorithm>

namespace varimarch
{
namespace
{

bool IsPlainPvm(const std::string& head)
{
  return head.compare(0, 4, "PVM\n") == 0 || head.compare(0, 5, "PVM2\n") == 0 ||
    head.compare(0, 5, "PVM3\n") == 0;
}

/// The bytes of a file, decompressed if necessary.
std::string DecodedFile(const std::string& path)
{
  std::string bytes = WholeFile(path);
  if (IsDifferentialStream(bytes))
  {
    bytes = DecodedDifferentialStream(path, bytes);
  }
  if (!IsPlainPvm(bytes))
  {
    FailToRead(path, "a PVM volume", "a file without its mark");
  }
  return bytes;
}

}

bool IsPvm(const std::string& head)
{
  return IsPlainPvm(head) || IsDifferentialStream(head);
}

Volume ReadPvm(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const std::string bytes = DecodedFile(path);
  HeaderWords words(path, bytes);
  const bool hasSpacing = words.Next() != "PVM";
  VoxelLayout layout = { {}, VTK_VOID };
  for (std::int64_t& dimension : layout.dimensions)
  {
    dimension = words.Integer("whole dimensions");
  }
  ImageGeometry geometry;
  for (int axis = 0; hasSpacing && axis < 3; ++axis)
  {
    geometry.axesMm[axis] *= words.Number("a spacing of numbers");
  }
  // Two bytes are one number of 16 bits, highest byte first; more are colours.
  const std::int64_t valueBytes = words.Integer("a number of bytes per voxel");
  const bool isShort = valueBytes == 2;
  layout.scalarType = isShort ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR;
  layout.componentCount = isShort ? 1 : valueBytes;
  const std::uint64_t voxelBytes = CheckedByteCount(path, layout);
  const std::uint64_t leftBytes = bytes.size() - words.Position();
  if (leftBytes < voxelBytes)
  {
    FailToRead(path, ByteText(double(voxelBytes)) + " of voxels", ByteText(double(leftBytes)));
  }

  Volume volume;
  progress.Report(0.5);
  volume.image = AllocatedImage(layout);
  std::copy_n(bytes.data() + words.Position(), voxelBytes,
    static_cast<char*>(volume.image->GetScalarPointer()));
  SwapToHostOrder(true, volume.image);
  PlaceImage(path, geometry, volume.image);
  if (!hasSpacing)
  {
    volume.warnings.push_back(UnknownSpacing);
  }
  return volume;
}

}
