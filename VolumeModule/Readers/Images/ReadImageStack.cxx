// Stacks of images: one file per slice, in a folder, in the natural order of their names.
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Images/Picture.h"
#include "Readers/Images/PictureFolder.h"
#include "Readers/Images/StackGeometry.h"
#include "Readers/Signatures.h"

#include <filesystem>

namespace varimarch
{
namespace
{

/// The pictures of a stack, and the names of the files that are not in it.
struct Stack
{
  std::vector<Picture> slices;
  std::string leftOut;

  void LeaveOut(const std::string& path)
  {
    this->leftOut += (this->leftOut.empty() ? "" : ", ");
    this->leftOut += std::filesystem::path(path).filename().string();
  }
};

/// Inspects all files, and leaves out the damaged ones.
Stack Inspected(const std::vector<std::string>& paths, ReadProgress progress)
{
  Stack stack;
  std::string fault;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    progress.Report(double(i) / double(paths.size()));
    try
    {
      stack.slices.push_back(InspectedPicture(paths[i]));
    }
    catch (const std::runtime_error& error)
    {
      stack.LeaveOut(paths[i]);
      fault = fault.empty() ? error.what() : fault;
    }
  }
  if (stack.slices.empty())
  {
    throw std::runtime_error(fault);
  }
  return stack;
}

/// Leaves out pictures of another size or type than most.
Stack OfOneLayout(const Stack& all)
{
  std::vector<VoxelLayout> layouts;
  for (const Picture& picture : all.slices)
  {
    layouts.push_back(picture.layout);
  }
  const VoxelLayout& usual = layouts[MostFrequent(layouts)];
  Stack stack = { {}, all.leftOut };
  for (const Picture& picture : all.slices)
  {
    if (IsSame(picture.layout, usual))
    {
      stack.slices.push_back(picture);
    }
    else
    {
      stack.LeaveOut(picture.path);
    }
  }
  return stack;
}

vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<Picture>& slices, ReadProgress progress)
{
  VoxelLayout layout = slices.front().layout;
  layout.dimensions[2] = std::int64_t(slices.size());
  const std::uint64_t sliceBytes = CheckedByteCount(path, layout) / slices.size();
  auto image = AllocatedImage(layout);
  auto* const voxels = static_cast<char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    progress.Report(double(i) / double(slices.size()));
    ReadPicture(slices[i], voxels + i * sliceBytes);
  }
  return image;
}

}

Volume ReadImageStack(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const bool isFolder = std::filesystem::is_directory(path);
  const PictureFolder pictures =
    isFolder ? PictureFolderAt(path) : PictureFolder{ { path }, "", 0.0 };
  const std::vector<std::string>& paths = pictures.slices;
  if (paths.empty())
  {
    FailToRead(path, "pictures of slices", "none");
  }
  if (paths.size() == 1 && IsTiff(FirstBytes(paths.front())))
  {
    return ReadTiff(paths.front(), options, progress);
  }
  const Stack stack = OfOneLayout(Inspected(paths, progress.Part(0.0, 0.2)));
  const std::vector<Picture>& slices = stack.slices;
  Volume volume;
  volume.image = ReadSlices(path, slices, progress.Part(0.2, 1.0));
  volume.holdsColors = slices.front().layout.componentCount > 1;
  if (!stack.leftOut.empty())
  {
    volume.warnings.push_back("Files were left out because they are damaged or of another size or "
                              "type than most: " +
      stack.leftOut + '.');
  }
  if (!pictures.preview.empty())
  {
    volume.warnings.push_back(
      "The picture " + pictures.preview + " is a preview of the scan; it was left out.");
  }
  const double voxelMm = pictures.voxelMm;
  const std::array<double, 3> spacingMm = voxelMm > 0.0
    ? std::array<double, 3>{ voxelMm, voxelMm, voxelMm }
    : std::array<double, 3>{ slices.front().spacingMm[0], slices.front().spacingMm[1], 0.0 };
  PlaceImage(
    path, StackGeometry(spacingMm, slices.front().orientation, volume.warnings), volume.image);
  return volume;
}

}
