#include "Readers/VoxelFile.h"

#include "Readers/FileError.h"
#include "Readers/Paging/MappedVoxels.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelLayout.h"

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

/// The files of the wanted one of several volumes.
/// @param valueCount  number of values of that volume
VoxelFile FilesOfVolume(const VoxelFile& file, std::uint64_t valueCount)
{
  const std::uint64_t fileCount = file.paths.size();
  if (fileCount == 1 || file.alternation > 0)
  {
    return file;
  }
  const auto volumeCount = std::uint64_t(file.volumeCount);
  if (fileCount % volumeCount != 0 || valueCount % (fileCount / volumeCount) != 0)
  {
    FailToRead(file.paths.front(), "data files that hold equal parts of the volume",
      std::to_string(fileCount) + " files");
  }
  const auto filesOfVolume = std::ptrdiff_t(fileCount / volumeCount);
  const auto begin = file.paths.begin() + std::ptrdiff_t(file.volume) * filesOfVolume;
  VoxelFile own = file;
  own.paths.assign(begin, begin + filesOfVolume);
  own.volumeCount = 1;
  own.volume = 0;
  return own;
}

/// One of several volumes that alternate in a stream, which is at its first value.
class OneOfAlternating : public ByteStream
{
public:
  /// @param runBytes  number of adjacent bytes of one volume
  OneOfAlternating(
    std::unique_ptr<ByteStream> all, std::uint64_t runBytes, std::int64_t volumeCount)
    : all(std::move(all))
    , runBytes(runBytes)
    , otherBytes(runBytes * std::uint64_t(volumeCount - 1))
    , leftInRun(runBytes)
  {
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    while (done < count)
    {
      if (this->leftInRun == 0)
      {
        this->all->Skip(this->otherBytes);
        this->leftInRun = this->runBytes;
      }
      const auto wanted = std::size_t(std::min<std::uint64_t>(count - done, this->leftInRun));
      const std::size_t got = this->all->Read(static_cast<char*>(buffer) + done, wanted);
      this->leftInRun -= got;
      done += got;
      if (got < wanted)
      {
        break;
      }
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->all->FileBytes(); }

private:
  std::unique_ptr<ByteStream> all;
  std::uint64_t runBytes;
  std::uint64_t otherBytes;
  std::uint64_t leftInRun;
};

/// The part of a volume that one file holds.
struct Part
{
  std::string path;
  int scalarType;
  std::uint64_t valueCount;

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

/// Bytes from the first value of the file to that of the wanted volume.
std::uint64_t BytesBefore(const VoxelFile& file, const Part& part)
{
  const std::uint64_t apart =
    file.alternation > 0 ? std::uint64_t(file.alternation) * part.ValueBytes() : part.Bytes();
  return file.encoding == VoxelEncoding::Text ? 0 : std::uint64_t(file.volume) * apart;
}

/// Offset of the first voxel of the wanted volume in a file that is not compressed.
std::uint64_t OffsetOfVoxels(const VoxelFile& file, const Part& part)
{
  const std::uint64_t begin =
    OffsetBehindLines(part.path, std::uint64_t(file.fileOffset), file.lineSkip);
  if (file.dataOffset != VoxelFile::FromEnd)
  {
    return begin + std::uint64_t(file.dataOffset) + BytesBefore(file, part);
  }
  const std::uint64_t all =
    ReadableFileSize(part.path) - std::min(begin, ReadableFileSize(part.path));
  return begin + all - std::min(all, part.Bytes() * std::uint64_t(file.volumeCount)) +
    BytesBefore(file, part);
}

/// A stream at the first value to read.
struct VoxelStream
{
  std::unique_ptr<ByteStream> stream;
  std::uint64_t begin;    ///< where its compressed bytes begin in the file
  std::uint64_t position; ///< decompressed bytes before the value
};

/// Opens a file at the first voxel of the wanted volume, or in a text at its first number.
VoxelStream StreamAtVoxels(const VoxelFile& file, const Part& part)
{
  if (file.compression == Compression::None)
  {
    const std::uint64_t offset = OffsetOfVoxels(file, part);
    return { OpenStream(part.path, file.compression, offset), 0, offset };
  }
  const std::uint64_t begin =
    OffsetBehindLines(part.path, std::uint64_t(file.fileOffset), file.lineSkip);
  std::uint64_t skip = std::uint64_t(file.dataOffset);
  if (file.dataOffset == VoxelFile::FromEnd)
  {
    const std::uint64_t all = OpenStream(part.path, file.compression, begin)
                                ->Skip(std::numeric_limits<std::uint64_t>::max());
    skip = all - std::min(all, part.Bytes() * std::uint64_t(file.volumeCount));
  }
  skip += BytesBefore(file, part);
  KeptStream once;
  KeptStream& kept = file.kept ? *file.kept : once;
  return { kept.TakeAt(part.path, file.compression, begin, skip), begin, skip };
}

/// Fails if a file is too short for its part of the voxels, whatever its bytes are.
void CheckFileHolds(const VoxelFile& file, const Part& part)
{
  const double fileBytes = double(ReadableFileSize(part.path));
  const double headerBytes = double(file.fileOffset);
  const bool isText = file.encoding == VoxelEncoding::Text;
  // A number and the separator after it take two bytes; the last one needs no separator.
  // The volumes behind the wanted one may be missing, or of alternating ones their last runs.
  const double otherValues = file.alternation > 0
    ? (double(part.valueCount) - double(file.alternation)) * double(file.volumeCount - 1) +
      double(file.volume) * double(file.alternation)
    : double(file.volume) * double(part.valueCount);
  const double values = double(part.valueCount) + otherValues;
  const double neededBytes = isText
    ? 2.0 * values - 1.0
    : values * double(part.ValueBytes()) + std::max(0.0, double(file.dataOffset));
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
  VoxelStream voxels = StreamAtVoxels(file, part);
  if (file.encoding == VoxelEncoding::Text)
  {
    NumberList numbers = { part.path, part.scalarType, part.valueCount };
    if (file.alternation > 0)
    {
      numbers.together = std::uint64_t(file.alternation);
      numbers.groups = std::uint64_t(file.volumeCount);
    }
    numbers.skipped =
      std::uint64_t(file.volume) * (file.alternation > 0 ? numbers.together : part.valueCount);
    ReadNumbers(numbers, *voxels.stream, destination, progress);
    return;
  }
  if (file.alternation > 0)
  {
    OneOfAlternating volume(std::move(voxels.stream),
      std::uint64_t(file.alternation) * part.ValueBytes(), file.volumeCount);
    ReadBytes(part.path, volume, destination, part.Bytes(), progress);
    return;
  }
  ReadBytes(part.path, *voxels.stream, destination, part.Bytes(), progress);
  if (file.kept && file.compression == Compression::Deflate)
  {
    file.kept->Keep(
      part.path, voxels.begin, voxels.position + part.Bytes(), std::move(voxels.stream));
  }
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

/// The image of voxels that stay in their file, because there are too many to be read; null if they
/// are to be read.
vtkSmartPointer<vtkImageData> ImageIfMapped(
  const VoxelFile& file, const Part& part, const VoxelLayout& layout, ReadProgress& progress)
{
  const std::uint64_t byteCount = ByteCountOf(part.path, layout);
  const std::uint64_t mostBytes = file.mapping.mostMemoryBytes;
  if (mostBytes == 0 || byteCount <= mostBytes / 4)
  {
    return nullptr;
  }
  const std::uint64_t offset =
    file.compression == Compression::None ? OffsetOfVoxels(file, part) : 0;
  const std::string obstacle = ObstacleToMapping(file, layout, offset);
  if (obstacle.empty())
  {
    return MappedImage({ part.path, layout, offset, file.mapping }, progress);
  }
  if (byteCount > mostBytes)
  {
    FailToRead(part.path,
      "voxels that fit in the memory of " + ByteText(double(mostBytes)) +
        ", or that can be drawn from disk",
      Text(layout) + " (" + ByteText(double(byteCount)) + ") that " + obstacle +
        "; store them uncompressed in one NRRD file, in this machine's byte order");
  }
  return nullptr;
}

}

Mapping MappingOf(const ReadOptions& options)
{
  return { MostMemoryBytes(options), options.preview };
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
  if (fileIsBigEndian != HostIsBigEndian && image->GetScalarSize() > 1)
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
  const std::uint64_t byteCount = ByteCountOf(allFiles.paths.front(), layout);
  const auto valueBytes = std::uint64_t(vtkDataArray::GetDataTypeSize(layout.scalarType));
  const VoxelFile file = FilesOfVolume(allFiles, byteCount / valueBytes);
  std::vector<Part> parts;
  for (const std::string& path : file.paths)
  {
    parts.push_back({ path, layout.scalarType, byteCount / valueBytes / file.paths.size() });
    CheckFileHolds(file, parts.back());
  }
  if (auto mapped = ImageIfMapped(file, parts.front(), layout, progress))
  {
    return mapped;
  }
  CheckedByteCount(file.paths.front(), layout);

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
