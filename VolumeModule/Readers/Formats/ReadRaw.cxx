// Raw voxels, optionally gzipped; the caller describes their layout.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/VoxelFile.h"

#include <vtkDataArray.h>

namespace varimarch
{

Volume ReadRaw(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const RawOptions& raw = options.raw;
  if (raw.dimensions == std::array<int, 3>{ 0, 0, 0 })
  {
    FailToRead(path, "dimensions of the raw voxels, which the caller must set", "none");
  }
  const bool isNumeric = vtkDataArray::GetDataTypeSize(raw.scalarType) > 0 &&
    raw.scalarType != VTK_BIT && raw.scalarType != VTK_STRING;
  if (!isNumeric)
  {
    FailToRead(path, "a numeric scalar type", "type " + std::to_string(raw.scalarType));
  }
  if (raw.headerBytes < 0)
  {
    FailToRead(path, "a header of at least 0 bytes", std::to_string(raw.headerBytes));
  }
  const VoxelLayout layout = { { raw.dimensions[0], raw.dimensions[1], raw.dimensions[2] },
    raw.scalarType, raw.componentCount };
  VoxelFile file;
  file.paths = { path };
  file.compression = CompressionOf(path);
  file.bigEndian = raw.bigEndian;
  file.dataOffset = raw.headerBytes;
  file.mapping = MappingOf(options);

  Volume volume;
  volume.image = ReadVoxels(file, layout, progress);
  const double expectedBytes = double(ByteCountOf(path, layout)) + double(raw.headerBytes);
  const double fileBytes = double(ReadableFileSize(path));
  if (file.compression == Compression::None && fileBytes > expectedBytes)
  {
    volume.warnings.push_back("The file is " + ByteText(fileBytes - expectedBytes) +
      " longer than the dimensions need, so they may be wrong.");
  }
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis][axis] = raw.spacingMm[axis];
  }
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
