#include "Readers/VoxelFile.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <algorithm>

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

/// Opens a file at its first voxel.
std::unique_ptr<ByteStream> StreamAtVoxels(
  const VoxelFile& file, const std::string& path, std::uint64_t partBytes)
{
  const std::uint64_t fileBytes = ReadableFileSize(path);
  std::uint64_t offset = std::uint64_t(file.fileOffset);
  if (file.fileOffset == VoxelFile::FromEnd)
  {
    offset = fileBytes - std::min(fileBytes, partBytes * std::uint64_t(file.volumeCount));
  }
  auto stream = OpenStream(path, file.compression, offset);
  stream->Skip(std::uint64_t(file.dataOffset));
  return stream;
}

/// Fails if a file is too short for its part of the voxels, whatever its bytes are.
void CheckFileHolds(
  const VoxelFile& file, const std::string& path, std::uint64_t partBytes, std::uint64_t partValues)
{
  const double fileBytes = double(ReadableFileSize(path));
  const double headerBytes = std::max(0.0, double(file.fileOffset));
  const bool isText = file.encoding == VoxelEncoding::Text;
  // A number and the separator after it take two bytes; the last one needs no separator.
  double neededBytes = isText ? 2.0 * partValues - 1.0 : double(partBytes) + file.dataOffset;
  const double mostBytes =
    std::max(0.0, fileBytes - headerBytes) * LargestRatio(file.compression);
  if (neededBytes > mostBytes)
  {
    FailToRead(path, ByteText(neededBytes) + " of voxels",
      ByteText(fileBytes) + (headerBytes > 0 ? " with a header of " + ByteText(headerBytes) : ""));
  }
}

/// Reads the values of one file.
void ReadPart(
  const VoxelFile& file, const NumberList& values, void* destination, ReadProgress progress)
{
  const auto valueBytes = std::uint64_t(vtkDataArray::GetDataTypeSize(values.scalarType));
  const std::uint64_t partBytes = values.count * valueBytes;
  const auto stream = StreamAtVoxels(file, values.path, partBytes);
  if (file.encoding == VoxelEncoding::Text)
  {
    ReadNumbers(values, *stream, destination, progress);
  }
  else
  {
    ReadBytes(values.path, *stream, destination, partBytes, progress);
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
  const std::uint64_t partBytes = byteCount / file.paths.size();
  for (const std::string& path : file.paths)
  {
    CheckFileHolds(file, path, partBytes, partBytes / valueBytes);
  }

  auto image = AllocatedImage(layout);
  auto* destination = static_cast<char*>(image->GetScalarPointer());
  const double partCount = double(file.paths.size());
  for (std::size_t part = 0; part < file.paths.size(); ++part)
  {
    const NumberList values = { file.paths[part], layout.scalarType, partBytes / valueBytes };
    ReadPart(file, values, destination + part * partBytes,
      progress.Part(double(part) / partCount, (part + 1.0) / partCount));
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
