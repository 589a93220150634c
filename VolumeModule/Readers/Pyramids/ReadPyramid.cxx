// Volumes in levels, read as a whole: OME-Zarr and HDF5.
#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Paging/ChunkedVoxels.h"
#include "Readers/Paging/PagedPyramid.h"
#include "Readers/Paging/Preview.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Pyramids/ZarrHeader.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <string>

namespace varimarch
{
namespace
{

/// The level that is read.
struct LevelChoice
{
  std::size_t level;
  std::string reason; ///< the sentence that says why it is not the finest; empty if it is
};

/// The voxels of a level.
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

/// Voxels that may be read as a whole: half of the memory, or of what is free of it, is left to
/// what is made of them.
double MostReadBytes(const ReadOptions& options)
{
  return 0.5 * std::min(FreeMemoryBytes(), double(MostMemoryBytes(options)));
}

/// The reason why the voxels of a level cannot stay in their chunks until they are needed, as the
/// rest of a sentence about them; empty if they can.
std::string ObstacleToPaging(const PyramidForm& form, std::size_t level, const ReadOptions& options)
{
  const std::optional<VoxelType> type = VoxelTypeOf(form.scalarType);
  if (!type)
  {
    return "are not of 8 bits, 16 bits or type float";
  }
  if (options.areCopies)
  {
    return "are packed in an archive";
  }
  const auto& size = form.levels[level].dimensions;
  if (*std::max_element(size.begin(), size.end()) > std::numeric_limits<int>::max())
  {
    return "are more than 2147483647 along an axis";
  }
  const std::uint64_t mostBytes = MostMemoryBytes(options);
  const std::uint64_t ofBricks = BytesOfBricks(
    form.levels[level], *type, SideOfBricks(form.levels[level], *type, mostBytes / 2));
  if (ofBricks > mostBytes / 2)
  {
    return "have bricks for which " + ByteText(2.0 * double(ofBricks)) + " are needed";
  }
  return ChunkedVoxels::Obstacle(
    form.levels[level], std::size_t(vtkDataArray::GetDataTypeSize(form.scalarType)), mostBytes);
}

/// Voxels of the chunks that a level has [bytes].
double StoredBytes(const DecodedPyramid& pyramid, std::size_t level)
{
  const double all = BytesOf(LayoutOf(pyramid.Form(), level));
  const std::vector<std::uint8_t> areThere = pyramid.Stored(int(level)).areThere;
  const auto count = double(std::count(areThere.begin(), areThere.end(), 1));
  return areThere.empty() ? all : all * count / double(areThere.size());
}

/// The reason why a level is not opened unless somebody asks for it, as the rest of a sentence
/// about its voxels; empty if it is.
std::string Hindrance(const PyramidOrder& order,
  const std::shared_ptr<const DecodedPyramid>& pyramid, std::size_t level)
{
  constexpr double MostBytes = 100e9; // at 100 MB a second a quarter of an hour
  const PyramidForm& form = pyramid->Form();
  const double bytes = BytesOf(LayoutOf(form, level));
  if (bytes <= MostReadBytes(order.options))
  {
    return "";
  }
  const std::string obstacle = ObstacleToPaging(form, level, order.options);
  if (!obstacle.empty())
  {
    return "need more than half of the free memory and " + obstacle;
  }
  const double stored = bytes > MostBytes ? StoredBytes(*pyramid, level) : 0.0;
  if (stored <= MostBytes || PagedPyramid(order, pyramid, level).IsSummarized())
  {
    return "";
  }
  constexpr double BytesPerHour = 100e6 * 3600.0;
  std::ostringstream hours;
  hours << std::fixed << std::setprecision(1) << stored / BytesPerHour;
  return "have to be read once before they are drawn, " + ByteText(stored) + " in " + hours.str() +
    " hours at 100 MB a second; ask for level " + std::to_string(level) + " to have them";
}

/// The level that was asked for, or the finest that can be read or stay in its chunks, and whose
/// ranges are made of at most 100 GB or kept already; the coarsest if there is none.
/// @throws std::runtime_error if a level was asked for that does not exist
LevelChoice LevelToRead(
  const PyramidOrder& order, const std::shared_ptr<const DecodedPyramid>& pyramid)
{
  const PyramidForm& form = pyramid->Form();
  const std::size_t count = form.levels.size();
  if (const std::optional<int> wanted = order.options.level)
  {
    if (*wanted < 0 || std::size_t(*wanted) >= count)
    {
      FailToRead(order.path, "a level from 0 to " + std::to_string(count - 1),
        "the wish for level " + std::to_string(*wanted));
    }
    return { std::size_t(*wanted), "" };
  }
  LevelChoice choice = { 0, "" };
  std::string ofFinest;
  while (choice.level + 1 < count)
  {
    const std::string hindrance = Hindrance(order, pyramid, choice.level);
    if (hindrance.empty())
    {
      break;
    }
    ofFinest = choice.level == 0 ? hindrance : ofFinest;
    ++choice.level;
  }
  if (choice.level > 0)
  {
    choice.reason = "Level " + std::to_string(choice.level) + ", " +
      Text(LayoutOf(form, choice.level)) + ", was read: the voxels of the finest, " +
      Text(LayoutOf(form, 0)) + ", " + ofFinest + ".";
  }
  return choice;
}

namespace fs = std::filesystem;

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

/// The image of a level.
struct LevelImage
{
  vtkSmartPointer<vtkImageData> image;
  std::int64_t missingChunks;
  std::size_t level;
};

/// A level that is read as a whole.
LevelImage ReadLevel(
  const std::string& path, const DecodedPyramid& pyramid, std::size_t level, ReadProgress& progress)
{
  const VoxelLayout layout = LayoutOf(pyramid.Form(), level);
  CheckedByteCount(path, layout);
  LevelImage read = { AllocatedImage(layout), 0, level };
  read.missingChunks = SlabReading(pyramid, level, read.image).Read(progress);
  return read;
}

/// The coarser level that serves as a preview of a level: the finest that is read within seconds
/// and fits into the memory. Empty if there is no such level.
std::optional<std::size_t> LevelOfPreview(
  const PyramidForm& form, std::size_t level, const ReadOptions& options)
{
  const double mostBytes = std::min(5e8, MostReadBytes(options));
  for (std::size_t coarser = level + 1; coarser < form.levels.size(); ++coarser)
  {
    if (BytesOf(LayoutOf(form, coarser)) <= mostBytes)
    {
      return coarser;
    }
  }
  return std::nullopt;
}

/// A level whose chunks are read when they are needed, or a preview of it.
LevelImage ReadPagedLevel(const PyramidOrder& order,
  const std::shared_ptr<const DecodedPyramid>& pyramid, std::size_t level, ReadProgress& progress)
{
  const PyramidForm& form = pyramid->Form();
  PagedPyramid paged(order, pyramid, level);
  const std::optional<std::size_t> coarser = LevelOfPreview(form, level, order.options);
  if (!paged.IsSummarized() && order.options.preview && coarser)
  {
    order.options.preview->sentence =
      SentenceAboutPreview(LayoutOf(form, *coarser), LayoutOf(form, level));
    return ReadLevel(order.path, *pyramid, *coarser, progress);
  }
  const std::int64_t missing = paged.MissingChunks();
  return { paged.Image(progress), missing, level };
}

/// Reads a level, or leaves it in its chunks if it does not fit.
LevelImage ImageOfLevel(const PyramidOrder& order,
  const std::shared_ptr<const DecodedPyramid>& pyramid, std::size_t level, ReadProgress& progress)
{
  const VoxelLayout layout = LayoutOf(pyramid->Form(), level);
  if (BytesOf(layout) <= MostReadBytes(order.options))
  {
    return ReadLevel(order.path, *pyramid, level, progress);
  }
  const std::string obstacle = ObstacleToPaging(pyramid->Form(), level, order.options);
  if (obstacle.empty())
  {
    return ReadPagedLevel(order, pyramid, level, progress);
  }
  const auto mostBytes = double(MostMemoryBytes(order.options));
  if (BytesOf(layout) > mostBytes)
  {
    FailToRead(order.path,
      "voxels that fit in the memory of " + ByteText(mostBytes) +
        ", or that can stay in their chunks",
      Text(layout) + " (" + ByteText(BytesOf(layout)) + ") that " + obstacle +
        "; choose a coarser level");
  }
  return ReadLevel(order.path, *pyramid, level, progress);
}

/// The volume of one channel, without the warning that there are others.
Volume ReadChannel(const PyramidOrder& order, const std::shared_ptr<const DecodedPyramid>& pyramid,
  ReadProgress& progress)
{
  const PyramidForm& form = pyramid->Form();
  const LevelChoice choice = LevelToRead(order, pyramid);
  const std::size_t level = choice.level;
  Volume volume;
  volume.windowLevel = form.windowLevel;
  volume.warnings = form.warnings;
  volume.times = form.times;
  if (!choice.reason.empty())
  {
    volume.warnings.push_back(choice.reason);
  }
  const LevelImage read = ImageOfLevel(order, pyramid, level, progress);
  volume.image = read.image;
  if (read.missingChunks > 0)
  {
    volume.warnings.push_back(std::to_string(read.missingChunks) +
      " chunks are not stored; their voxels have the fill value of the array.");
  }
  PlaceImage(order.path, form.geometries[read.level], volume.image);
  return volume;
}

/// True if all channels are wanted and can be read as a whole.
bool ReadsAllChannels(
  const PyramidOrder& order, const std::shared_ptr<const DecodedPyramid>& pyramid)
{
  const PyramidForm& form = pyramid->Form();
  return form.channels.size() > 1 &&
    double(form.channels.size()) * BytesOf(LayoutOf(form, LevelToRead(order, pyramid).level)) <=
    MostReadBytes(order.options);
}

/// Reads the channels one after another, as components.
Volume ReadAllChannels(const PyramidOrder& order,
  const std::shared_ptr<const DecodedPyramid>& first, ReadProgress& progress)
{
  const std::size_t count = first->Form().channels.size();
  Volume volume;
  vtkSmartPointer<vtkImageData> joined;
  for (std::size_t i = 0; i < count; ++i)
  {
    ReadProgress part = progress.Part(double(i) / double(count), double(i + 1) / double(count));
    PyramidOrder ofChannel = order;
    ofChannel.options.channel = int(i);
    const Volume read = ReadChannel(
      ofChannel, i == 0 ? first : std::make_shared<const DecodedPyramid>(ofChannel, part), part);
    if (i == 0)
    {
      volume = read;
      VoxelLayout layout = LayoutOf(first->Form(), 0);
      std::copy_n(read.image->GetDimensions(), 3, layout.dimensions.begin());
      layout.componentCount = std::int64_t(count);
      CheckedByteCount(order.path, layout);
      joined = AllocatedImage(layout);
    }
    joined->GetPointData()->GetScalars()->CopyComponent(
      int(i), read.image->GetPointData()->GetScalars(), 0);
  }
  joined->SetOrigin(volume.image->GetOrigin());
  joined->SetSpacing(volume.image->GetSpacing());
  joined->SetDirectionMatrix(volume.image->GetDirectionMatrix());
  volume.image = joined;
  volume.channels = first->Form().channels;
  return volume;
}

Volume ReadPyramid(PyramidOrder order, ReadProgress& progress)
{
  const bool wantsAll = order.options.channel == AllChannels;
  order.options.channel = wantsAll ? 0 : order.options.channel;
  const auto pyramid = std::make_shared<const DecodedPyramid>(order, progress);
  if (wantsAll && ReadsAllChannels(order, pyramid))
  {
    return ReadAllChannels(order, pyramid, progress);
  }
  Volume volume = ReadChannel(order, pyramid, progress);
  if (!pyramid->Form().otherChannels.empty())
  {
    volume.warnings.push_back(pyramid->Form().otherChannels);
  }
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
