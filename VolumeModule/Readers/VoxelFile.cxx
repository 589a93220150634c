#include "Readers/VoxelFile.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace varimarch
{
namespace
{

/// The files of the first of several volumes.
/// @param valueCount  number of values of that volume
VoxelFile FirstVolume(const VoxelFile& file, std::uint64_t valueCount)
{
  VoxelFile first = file;
  const std::uint64_t fileCount = file.paths.size();
  if (fileCount == 1)
  {
    return first;
  }
  const auto volumeCount = std::uint64_t(file.volumeCount);
  if (fileCount % volumeCount != 0 || valueCount % (fileCount / volumeCount) != 0)
  {
    FailToRead(file.paths.front(), "data files that hold equal parts of the volume",
      std::to_string(fileCount) + " files");
  }
  first.paths.resize(std::size_t(fileCount / volumeCount));
  first.volumeCount = 1;
  return first;
}

/// The bytes of the first of several volumes whose values alternate.
class FirstOfAlternating : public ByteStream
{
public:
  /// @param voxelBytes  size of a voxel of one volume
  FirstOfAlternating(
    std::unique_ptr<ByteStream> all, std::uint64_t voxelBytes, std::uint64_t volumeCount)
    : all(std::move(all))
    , voxelBytes(voxelBytes)
    , otherBytes(voxelBytes * (volumeCount - 1))
  {
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    std::size_t got = 1;
    while (done < count && got > 0)
    {
      if (this->place == this->voxelBytes)
      {
        this->all->Skip(this->otherBytes);
        this->place = 0;
      }
      const auto wanted = std::min<std::uint64_t>(count - done, this->voxelBytes - this->place);
      got = this->all->Read(static_cast<char*>(buffer) + done, std::size_t(wanted));
      this->place += got;
      done += got;
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->all->FileBytes(); }

private:
  std::unique_ptr<ByteStream> all;
  std::uint64_t voxelBytes;
  std::uint64_t otherBytes;
  std::uint64_t place = 0; ///< number of bytes of the current voxel that were read
};

/// The part of a volume that one file holds.
struct Part
{
  std::string path;
  int scalarType;
  std::uint64_t valueCount;
  std::uint64_t valuesPerVoxel;

  std::uint64_t Bytes() const { return this->valueCount * this->ValueBytes(); }
  std::uint64_t ValueBytes() const
  {
    return std::uint64_t(vtkDataArray::GetDataTypeSize(this->scalarType));
  }
};

/// Offset after a number of lines.
std::uint64_t OffsetBehindLines(const std::string& path, std::uint64_t offset, std::int64_t count)
{
  const auto stream = OpenStream(path, Compression::None, offset);
  for (char character; count > 0 && stream->Read(&character, 1) == 1; ++offset)
  {
    count -= character == '\n' ? 1 : 0;
  }
  return offset;
}

/// Opens a file at its first voxel.
std::unique_ptr<ByteStream> StreamAtVoxels(const VoxelFile& file, const Part& part)
{
  const std::uint64_t begin =
    OffsetBehindLines(part.path, std::uint64_t(file.fileOffset), file.lineSkip);
  std::uint64_t skip = std::uint64_t(file.dataOffset);
  if (file.dataOffset == VoxelFile::FromEnd)
  {
    const std::uint64_t all = file.compression == Compression::None
      ? ReadableFileSize(part.path) - begin
      : OpenStream(part.path, file.compression, begin)
          ->Skip(std::numeric_limits<std::uint64_t>::max());
    skip =
      all - std::min(all, part.Bytes() * std::uint64_t(file.volumeCount * file.alternatingCount));
  }
  if (file.compression == Compression::None)
  {
    return OpenStream(part.path, file.compression, begin + skip);
  }
  auto stream = OpenStream(part.path, file.compression, begin);
  stream->Skip(skip);
  return stream;
}

/// Fails if a file is too short for its part of the voxels, whatever its bytes are.
void CheckFileHolds(const VoxelFile& file, const Part& part)
{
  const double fileBytes = double(ReadableFileSize(part.path));
  const double headerBytes = double(file.fileOffset);
  const bool isText = file.encoding == VoxelEncoding::Text;
  // A number and the separator after it take two bytes; the last one needs no separator.
  const double neededBytes = double(file.alternatingCount) *
      (isText ? 2.0 * double(part.valueCount) - 1.0 : double(part.Bytes())) +
    std::max(0.0, double(file.dataOffset));
  const double mostBytes = std::max(0.0, fileBytes - headerBytes) * LargestRatio(file.compression);
  if (neededBytes > mostBytes)
  {
    FailToRead(part.path, ByteText(neededBytes) + " of voxels",
      ByteText(fileBytes) + (headerBytes > 0 ? " with a header of " + ByteText(headerBytes) : ""));
  }
}

/// Reads the values of one file.
void ReadPart(const VoxelFile& file, const Part& part, void* destination, ReadProgress progress)
{
  auto stream = StreamAtVoxels(file, part);
  if (file.encoding == VoxelEncoding::Text)
  {
    ReadNumbers({ part.path, part.scalarType, part.valueCount, part.valuesPerVoxel,
                  std::uint64_t(file.alternatingCount) },
      *stream, destination, progress);
    return;
  }
  if (file.alternatingCount > 1)
  {
    stream = std::make_unique<FirstOfAlternating>(std::move(stream),
      part.valuesPerVoxel * part.ValueBytes(), std::uint64_t(file.alternatingCount));
  }
  ReadBytes(part.path, *stream, destination, part.Bytes(), progress);
}

/// Reorders from component by component to voxel by voxel.
void Interleave(vtkImageData* image)
{
  const int componentCount = image->GetNumberOfScalarComponents();
  const std::size_t voxelCount = std::size_t(image->GetNumberOfPoints());
  const std::size_t valueBytes = std::size_t(image->GetScalarSize());
  char* values = static_cast<char*>(image->GetScalarPointer());
  const std::vector<char> planes(values, values + voxelCount * componentCount * valueBytes);
  for (int component = 0; component < componentCount; ++component)
  {
    const char* plane = planes.data() + component * voxelCount * valueBytes;
    for (std::size_t voxel = 0; voxel < voxelCount; ++voxel)
    {
      std::copy_n(plane + voxel * valueBytes, valueBytes,
        values + (voxel * componentCount + component) * valueBytes);
    }
  }
}

}

void ReadBytes(const std::string& path, ByteStream& stream, void* destination,
  std::uint64_t byteCount, ReadProgress& progress)
{
  constexpr std::uint64_t chunkBytes = 1 << 22;
  std::uint64_t done = 0;
  while (done < byteCount)
  {
    progress.Report(double(done) / double(byteCount));
    const std::size_t wanted = std::size_t(std::min(chunkBytes, byteCount - done));
    const std::size_t got = stream.Read(static_cast<char*>(destination) + done, wanted);
    done += got;
    if (got < wanted)
    {
      FailToRead(path, std::to_string(byteCount) + " bytes of voxels", std::to_string(done));
    }
  }
}

void SwapToHostOrder(bool fileIsBigEndian, vtkImageData* image)
{
#ifdef VTK_WORDS_BIGENDIAN
  constexpr bool hostIsBigEndian = true;
#else
  constexpr bool hostIsBigEndian = false;
#endif
  if (fileIsBigEndian != hostIsBigEndian && image->GetScalarSize() > 1)
  {
    const auto valueCount =
      std::size_t(image->GetNumberOfPoints()) * image->GetNumberOfScalarComponents();
    vtkByteSwap::SwapVoidRange(image->GetScalarPointer(), valueCount, image->GetScalarSize());
  }
}

vtkSmartPointer<vtkImageData> ReadVoxels(
  const VoxelFile& allFiles, const VoxelLayout& layout, ReadProgress& progress)
{
  // Detects all detectable errors before memory is allocated.
  const std::uint64_t byteCount = CheckedByteCount(allFiles.paths.front(), layout);
  const auto valueBytes = std::uint64_t(vtkDataArray::GetDataTypeSize(layout.scalarType));
  const VoxelFile file = FirstVolume(allFiles, byteCount / valueBytes);
  std::vector<Part> parts;
  for (const std::string& path : file.paths)
  {
    parts.push_back({ path, layout.scalarType, byteCount / valueBytes / file.paths.size(),
      std::uint64_t(layout.componentCount) });
    CheckFileHolds(file, parts.back());
  }

  auto image = AllocatedImage(layout);
  auto* destination = static_cast<char*>(image->GetScalarPointer());
  const double partCount = double(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    ReadPart(file, parts[i], destination + i * parts[i].Bytes(),
      progress.Part(double(i) / partCount, double(i + 1) / partCount));
  }
  if (file.encoding == VoxelEncoding::Binary)
  {
    SwapToHostOrder(file.bigEndian, image);
  }
  if (file.planar && layout.componentCount > 1)
  {
    Interleave(image);
  }
  return image;
}

}
