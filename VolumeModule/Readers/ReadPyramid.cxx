// Volumes in levels, read as a whole: OME-Zarr and HDF5.
#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Memory.h"
#include "Readers/Pyramids/Hdf5Path.h"
#include "Readers/Pyramids/ZarrHeader.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

VoxelLayout LayoutOf(const PyramidForm& form, std::size_t level)
{
  return { form.levels[level].dimensions, form.scalarType, 1 };
}

double BytesOf(const VoxelLayout& layout)
{
  double bytes = double(vtkDataArray::GetDataTypeSize(layout.scalarType));
  for (const std::int64_t dimension : layout.dimensions)
  {
    bytes *= double(dimension);
  }
  return bytes;
}

/// The level that was asked for, or the finest that leaves half of the free memory to what is made
/// of the voxels; the coarsest if none does.
std::size_t LevelToRead(
  const std::string& path, const PyramidForm& form, const std::optional<int>& wanted)
{
  const std::size_t count = form.levels.size();
  if (wanted)
  {
    if (*wanted < 0 || std::size_t(*wanted) >= count)
    {
      FailToRead(path, "a level from 0 to " + std::to_string(count - 1),
        "the wish for level " + std::to_string(*wanted));
    }
    return std::size_t(*wanted);
  }
  const double mostBytes = 0.5 * FreeMemoryBytes();
  std::size_t level = 0;
  while (level + 1 < count && BytesOf(LayoutOf(form, level)) > mostBytes)
  {
    ++level;
  }
  return level;
}

/// The boxes of a level that are read one after another: whole chunks in rows of slices.
class SlabReading
{
public:
  SlabReading(const DecodedPyramid& pyramid, std::size_t level, vtkImageData* image)
    : pyramid(pyramid)
    , level(int(level))
    , form(pyramid.Form().levels[level])
    , image(image)
  {
  }

  /// @returns the number of chunks that the file does not have
  std::int64_t Read(ReadProgress& progress)
  {
    // Thin slabs are read together, so that all processors have chunks.
    constexpr double LeastBytes = 64e6;
    const std::int64_t depth = this->form.dimensions[2];
    const double slabBytes = double(this->form.dimensions[0]) * double(this->form.dimensions[1]) *
      double(this->form.chunk[2]) * double(this->image->GetScalarSize());
    const double slabs = std::clamp(LeastBytes / slabBytes, 1.0, double(depth));
    const std::int64_t step = this->form.chunk[2] * std::int64_t(slabs);
    std::int64_t missing = 0;
    for (std::int64_t begin = 0; begin < depth; begin += step)
    {
      const std::int64_t end = std::min(depth, begin + step);
      ReadProgress part = progress.Part(double(begin) / double(depth), double(end) / double(depth));
      missing += this->ReadSlab(begin, end, part);
    }
    return missing;
  }

private:
  /// Reads slices from `begin` to before `end`, in strips of rows that a decoder can have in
  /// memory.
  std::int64_t ReadSlab(std::int64_t begin, std::int64_t end, ReadProgress& progress)
  {
    constexpr double StripBytes = 256e6;
    const std::int64_t height = this->form.dimensions[1];
    const double chunkRows = double(this->form.chunk[1]);
    const double rowBytes =
      double(this->form.dimensions[0]) * double(end - begin) * double(this->image->GetScalarSize());
    const double stripChunks =
      std::max(1.0, std::min(StripBytes / (chunkRows * rowBytes), double(height)));
    const std::int64_t strip = std::int64_t(stripChunks) * this->form.chunk[1];
    std::int64_t missing = 0;
    for (std::int64_t row = 0; row < height; row += strip)
    {
      progress.Report(double(row) / double(height));
      missing += this->ReadStrip(
        { { 0, row, begin }, { this->form.dimensions[0], std::min(height, row + strip), end } });
    }
    return missing;
  }

  /// A strip of all rows lies in the image as in the box; of others, each slice does.
  std::int64_t ReadStrip(const BrickSource::Box& box)
  {
    ReadProgress silent([](double) { return true; });
    const auto size = SizeOf(box);
    if (size[1] == this->form.dimensions[1] || size[2] == 1)
    {
      return this->pyramid.ReadStored(this->level, box, this->Place(box), silent);
    }
    const auto sliceBytes = std::size_t(size[0] * size[1] * this->image->GetScalarSize());
    std::vector<char> voxels(sliceBytes * std::size_t(size[2]));
    const std::int64_t missing = this->pyramid.ReadStored(this->level, box, voxels.data(), silent);
    for (std::int64_t slice = 0; slice < size[2]; ++slice)
    {
      BrickSource::Box place = box;
      place.lower[2] += slice;
      std::memcpy(this->Place(place), voxels.data() + std::size_t(slice) * sliceBytes, sliceBytes);
    }
    return missing;
  }

  void* Place(const BrickSource::Box& box)
  {
    return this->image->GetScalarPointer(int(box.lower[0]), int(box.lower[1]), int(box.lower[2]));
  }

  const DecodedPyramid& pyramid;
  int level;
  const BrickSource::Level& form;
  vtkImageData* image;
};

Volume ReadPyramid(const PyramidOrder& order, ReadProgress& progress)
{
  const DecodedPyramid pyramid(order, progress);
  const PyramidForm& form = pyramid.Form();
  const std::size_t level = LevelToRead(order.path, form, order.options.level);
  const VoxelLayout layout = LayoutOf(form, level);
  CheckedByteCount(order.path, layout);
  Volume volume;
  volume.windowLevel = form.windowLevel;
  volume.warnings = form.warnings;
  if (level > 0 && !order.options.level)
  {
    volume.warnings.push_back("Level " + std::to_string(level) + ", " + Text(layout) +
      ", was read, since the finest, " + Text(LayoutOf(form, 0)) +
      ", does not fit in half of the free memory.");
  }
  volume.image = AllocatedImage(layout);
  const std::int64_t missing = SlabReading(pyramid, level, volume.image).Read(progress);
  if (missing > 0)
  {
    volume.warnings.push_back(std::to_string(missing) +
      " chunks are not in the folder; their voxels have the fill value of the array.");
  }
  PlaceImage(order.path, form.geometries[level], volume.image);
  return volume;
}

bool IsZarrFolder(const fs::path& folder)
{
  std::error_code unknown;
  const char* const marks[] = { ZarrArrayFile, ZarrAttributesFile, ZarrGroupFile, ZarrOfVersion3 };
  return std::any_of(std::begin(marks), std::end(marks),
    [&](const char* mark) { return fs::is_regular_file(folder / mark, unknown); });
}

/// The folder of Zarr that a path means: itself, that of a file in it, or the only one in a folder,
/// as in an archive. Empty if there is none.
std::string ZarrFolderOf(const std::string& path)
{
  std::error_code unknown;
  if (!fs::is_directory(path, unknown))
  {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
  }
  if (IsZarrFolder(path))
  {
    return path;
  }
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(path, unknown);
       !unknown && entry != fs::directory_iterator() && entries.size() < 2;
       entry.increment(unknown))
  {
    if (entry->path().filename() != "__MACOSX")
    {
      entries.push_back(entry->path());
    }
  }
  return entries.size() == 1 && IsZarrFolder(entries.front()) ? entries.front().string() : "";
}

}

bool HoldsZarr(const std::string& folder)
{
  return !ZarrFolderOf(folder).empty();
}

bool IsZarr(const std::string& head)
{
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  const char* const keys[] = { "\"zarr_format\"", "\"multiscales\"", "\"omero\"",
    "\"bioformats2raw.layout\"" };
  return begin != std::string::npos && head[begin] == '{' &&
    std::any_of(std::begin(keys), std::end(keys),
      [&](const char* key) { return head.find(key) != std::string::npos; });
}

Volume ReadZarr(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadPyramid({ PyramidFormat::Zarr, ZarrFolderOf(path), options }, progress);
}

Volume ReadHdf5(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadPyramid({ PyramidFormat::Hdf5, path, options }, progress);
}

std::unique_ptr<DecodedPyramid> OpenPyramidAt(
  const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const VolumeFormat* const format = FormatOfFile(path, options);
  const bool isZarr = format && format->read == ReadZarr;
  if (!isZarr && (!format || format->read != ReadHdf5))
  {
    return nullptr;
  }
  const PyramidOrder order = { isZarr ? PyramidFormat::Zarr : PyramidFormat::Hdf5,
    isZarr ? ZarrFolderOf(path) : path, options };
  return std::make_unique<DecodedPyramid>(order, progress);
}

}
