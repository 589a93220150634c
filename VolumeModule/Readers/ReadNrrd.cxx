// NRRD: a text header with the voxels in the same file (.nrrd) or in others (.nhdr). See
// http://teem.sourceforge.net/nrrd/format.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/KeptInput.h"
#include "Readers/Magnitude.h"
#include "Readers/NrrdAxes.h"
#include "Readers/NrrdGeometry.h"
#include "Readers/NrrdSegments.h"
#include "Readers/NumberText.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <vtkDataArray.h>

#include <algorithm>

namespace varimarch
{
namespace
{

/// Number of bytes or lines to skip; 0 if the field is missing, VoxelFile::FromEnd for -1.
std::int64_t Skip(const NrrdHeader& header, const std::string& key)
{
  const std::string value = header.fields.Value({ key });
  const std::int64_t skip =
    value.empty() ? 0 : IntegerFromText(header.path, "a number as " + key, value);
  if (skip < VoxelFile::FromEnd)
  {
    FailToRead(header.path, "at least -1 as " + key, value);
  }
  return skip;
}

void SetEncoding(const NrrdHeader& header, VoxelFile& file)
{
  const std::string encoding = LowerCase(header.fields.Value({ "encoding" }));
  if (encoding == "gzip" || encoding == "gz")
  {
    file.compression = Compression::Deflate;
  }
  else if (encoding == "bzip2" || encoding == "bz2")
  {
    file.compression = Compression::Other;
  }
  else if (encoding == "hex")
  {
    file.compression = Compression::Hexadecimal;
  }
  else if (encoding == "txt" || encoding == "text" || encoding == "ascii")
  {
    file.encoding = VoxelEncoding::Text;
  }
  else if (encoding != "raw")
  {
    FailToRead(header.path, "the encoding raw, gzip, bzip2, hex or ascii", Quoted(encoding));
  }
}

VoxelFile VoxelFileOf(const NrrdHeader& header)
{
  VoxelFile file;
  SetEncoding(header, file);
  file.bigEndian = LowerCase(header.fields.Value({ "endian" })) == "big";
  if (header.fields.Has("datafile"))
  {
    file.paths = DataFiles(header.path, header.fields.Value({ "datafile" }), header.listedFiles);
  }
  else
  {
    file.paths = { header.path };
    file.fileOffset = std::int64_t(header.end);
  }

  file.lineSkip = Skip(header, "lineskip");
  file.dataOffset = Skip(header, "byteskip");
  return file;
}

}

Volume ReadNrrd(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  Volume volume;
  const NrrdHeader header = ReadNrrdHeader(path);
  const bool holdsSegments = HoldsSegments(header);
  const NrrdAxes axes = holdsSegments ? LayersAsComponents(AxesOf(header)) : AxesOf(header);
  TakeTimes(path, TimesOf(header, axes), options, volume);
  const VoxelLayout layout = LayoutOf(header, axes);
  const ImageGeometry geometry = GeometryOf(header, axes, volume.warnings);
  VoxelFile file = VoxelFileOf(header);
  file.planar = axes.planar;
  file.volumeCount = axes.volumeCount;
  file.volume = options.time;
  file.kept = StreamOf(options);
  file.alternation = axes.areAlternating ? 1 : 0;
  file.conversion = holdsSegments ? "joined to segments" : "";
  file.mapping = MappingOf(options);
  const bool needsByteOrder =
    file.encoding == VoxelEncoding::Binary && vtkDataArray::GetDataTypeSize(layout.scalarType) > 1;
  if (needsByteOrder && !header.fields.Has("endian"))
  {
    volume.warnings.push_back(UnknownByteOrder);
  }
  volume.image = ReadVoxels(file, layout, progress);
  if (holdsSegments)
  {
    TakeSegments(header, volume);
  }
  else if (axes.areComplex)
  {
    TakeMagnitude("The numbers are complex", volume);
  }
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
