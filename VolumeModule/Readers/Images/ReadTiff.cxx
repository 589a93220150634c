// TIFF files of several pages: those that a program describes, and plain ones. libtiff decodes
// them.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Times.h"

#include <vtkDataArray.h>

#include <algorithm>

namespace varimarch
{
namespace
{

/// The files of a stack, of which one is open at a time.
class OpenTiff
{
public:
  explicit OpenTiff(std::unique_ptr<TiffFile> first)
    : file(std::move(first))
  {
  }

  TiffFile& At(const TiffPlane& plane)
  {
    if (this->file->Path() != plane.path)
    {
      this->file = std::make_unique<TiffFile>(plane.path);
    }
    if (plane.page >= this->file->Pages().size())
    {
      FailToRead(plane.path, std::to_string(plane.page + 1) + " pages",
        std::to_string(this->file->Pages().size()));
    }
    return *this->file;
  }

private:
  std::unique_ptr<TiffFile> file;
};

/// Keeps the first channel of a stack whose channels are more than the components of a voxel.
void LimitChannels(TiffStack& stack, std::int64_t componentsPerPage)
{
  if (std::int64_t(stack.channelCount) * componentsPerPage <= 4)
  {
    return;
  }
  stack.warnings.push_back("The file holds " + std::to_string(stack.channelCount) +
    " channels, but a voxel has at most 4 components; only the first channel was read.");
  std::vector<TiffPlane> first;
  for (std::size_t i = 0; i < stack.planes.size(); i += stack.channelCount)
  {
    first.push_back(stack.planes[i]);
  }
  stack.planes = first;
  stack.channelCount = 1;
  stack.channels.clear();
}

/// Checks all pages before memory is allocated.
/// @returns the layout of the volume
VoxelLayout CheckedLayout(const TiffStack& stack, const VoxelLayout& page, OpenTiff& files)
{
  VoxelLayout layout = page;
  layout.dimensions[2] = std::int64_t(stack.planes.size() / stack.channelCount);
  layout.componentCount *= std::int64_t(stack.channelCount);
  for (const TiffPlane& plane : stack.planes)
  {
    TiffFile& file = files.At(plane);
    const VoxelLayout& own = file.Pages()[plane.page].layout;
    if (!IsSame(own, page))
    {
      FailToRead(plane.path, "pages of " + Text(page),
        Text(own) + " in page " + std::to_string(plane.page + 1));
    }
    file.CheckHoldsPage(plane.page);
  }
  CheckedByteCount(stack.planes.front().path, layout);
  return layout;
}

vtkSmartPointer<vtkImageData> ReadPlanes(
  const TiffStack& stack, const VoxelLayout& page, OpenTiff& files, ReadProgress& progress)
{
  const VoxelLayout layout = CheckedLayout(stack, page, files);
  auto image = AllocatedImage(layout);
  const auto pixelBytes =
    std::size_t(vtkDataArray::GetDataTypeSize(page.scalarType)) * std::size_t(page.componentCount);
  const std::size_t voxelBytes = pixelBytes * stack.channelCount;
  const auto pixelCount = std::size_t(page.dimensions[0] * page.dimensions[1]);
  std::vector<char> pixels(stack.channelCount > 1 ? pixelCount * pixelBytes : 0);
  auto* const voxels = static_cast<char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < stack.planes.size(); ++i)
  {
    progress.Report(double(i) / double(stack.planes.size()));
    TiffFile& file = files.At(stack.planes[i]);
    char* const slice = voxels + i / stack.channelCount * pixelCount * voxelBytes;
    file.ReadPage(stack.planes[i].page, pixels.empty() ? slice : pixels.data());
    char* component = slice + i % stack.channelCount * pixelBytes;
    for (auto pixel = pixels.begin(); pixel != pixels.end(); pixel += std::ptrdiff_t(pixelBytes))
    {
      std::copy_n(pixel, pixelBytes, component);
      component += voxelBytes;
    }
  }
  return image;
}

/// The components of the voxels, which are channels.
/// @param perPage  components of each page
std::vector<VolumeChannel> NamedChannels(const TiffStack& stack, std::size_t perPage)
{
  if (perPage == 1 && stack.channels.size() == stack.channelCount)
  {
    return stack.channels;
  }
  std::vector<VolumeChannel> channels;
  for (std::size_t i = 0; i < stack.channelCount * perPage; ++i)
  {
    channels.push_back({ "Channel " + std::to_string(i + 1), {} });
  }
  return channels;
}

/// The stack that a program describes in the file; nothing if none does.
std::optional<TiffStack> DescribedStack(TiffFile& file, std::int64_t time)
{
  std::optional<TiffStack> stack = OmeStack(file, time);
  stack = stack ? stack : ImageJStack(file, time);
  stack = stack ? stack : ShapedStack(file, time);
  stack = stack ? stack : StkStack(file, time);
  return stack ? stack : LsmStack(file, time);
}

}

Volume ReadTiff(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  auto file = std::make_unique<TiffFile>(path);
  const std::optional<TiffStack> described = DescribedStack(*file, options.time);
  const bool isPlain = !described;
  TiffStack stack = isPlain ? PlainStack(*file) : *described;
  const TiffPage first = file->Pages()[stack.planes.front().page];
  LimitChannels(stack, first.layout.componentCount);

  OpenTiff files(std::move(file));
  Volume volume;
  TakeTimes(path, stack.times, options, volume);
  volume.image =
    Rescaled(path, ReadPlanes(stack, first.layout, files, progress), { stack.rescale });
  volume.holdsColors = stack.channelCount == 1 && first.holdsColors;
  if (!volume.holdsColors)
  {
    volume.channels = NamedChannels(stack, std::size_t(first.layout.componentCount));
  }
  volume.warnings = stack.warnings;
  volume.isInverted = first.isInverted;
  PlaceImage(path, StackGeometry(stack.spacingMm, isPlain ? first.orientation : 1, volume.warnings),
    volume.image);
  return volume;
}

TiffStack PlainStack(const TiffFile& file)
{
  // Pages of the same layout are slices; thumbnails and scout images have another one.
  std::vector<VoxelLayout> layouts;
  std::vector<std::size_t> numbers;
  for (std::size_t page = 0; page < file.Pages().size(); ++page)
  {
    if (!file.Pages()[page].isReduced)
    {
      layouts.push_back(file.Pages()[page].layout);
      numbers.push_back(page);
    }
  }
  if (layouts.empty())
  {
    FailToRead(file.Path(), "pages of full size", "only thumbnails");
  }
  const VoxelLayout& usual = layouts[MostFrequent(layouts)];
  TiffStack stack;
  std::string others;
  for (std::size_t i = 0; i < layouts.size(); ++i)
  {
    if (IsSame(layouts[i], usual))
    {
      stack.planes.push_back({ file.Path(), numbers[i] });
    }
    else
    {
      others += (others.empty() ? "" : ", ") + std::to_string(numbers[i] + 1);
    }
  }
  if (!others.empty())
  {
    stack.warnings.push_back(
      "Pages of another size or type than most were left out: " + others + ".");
  }
  const std::array<double, 2> spacingMm = PixelSpacingMm(file.Pages()[stack.planes[0].page]);
  stack.spacingMm = { spacingMm[0], spacingMm[1], 0.0 };
  return stack;
}

}
