// MINC 1 and 2, the formats of the Montreal Neurological Institute: netCDF and HDF5 files with the
// same contents. Their own libraries read them.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Formats/MincFile.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

/// The world axis of a dimension: 0 to 2, or -1 if it is not spatial.
int WorldAxis(const MincAxis& axis)
{
  const std::string names[3] = { "xspace", "yspace", "zspace" };
  const auto* const name = std::find(std::begin(names), std::end(names), axis.name);
  return name == std::end(names) ? -1 : int(name - std::begin(names));
}

bool IsComponents(const MincAxis& axis)
{
  return axis.name == "vector_dimension";
}

/// The dimensions of the volume, fastest first.
std::vector<MincAxis> SpatialAxes(const std::string& path, const MincFile& file)
{
  std::vector<MincAxis> axes;
  bool seen[3] = {};
  for (auto axis = file.axes.rbegin(); axis != file.axes.rend(); ++axis)
  {
    const int world = WorldAxis(*axis);
    if (world >= 0 && !seen[world])
    {
      seen[world] = true;
      axes.push_back(*axis);
    }
  }
  const bool hasComponents = !file.axes.empty() && IsComponents(file.axes.back());
  const std::size_t others = file.axes.size() - axes.size() - (hasComponents ? 1 : 0);
  // Other dimensions must be slower than those of the volume.
  bool isInOrder = axes.size() == 3;
  for (std::size_t i = 0; i < others; ++i)
  {
    isInOrder = isInOrder && WorldAxis(file.axes[i]) < 0;
  }
  if (!isInOrder)
  {
    FailToRead(path, "an image whose fastest dimensions are xspace, yspace and zspace",
      std::to_string(axes.size()) + " of them among " + std::to_string(file.axes.size()));
  }
  const auto irregular =
    std::find_if(axes.begin(), axes.end(), [](const MincAxis& axis) { return axis.isIrregular; });
  if (irregular != axes.end())
  {
    FailToRead(path, "regular spacing of voxels", "irregular spacing along " + irregular->name);
  }
  return axes;
}

VoxelLayout LayoutOf(
  const std::string& path, const MincFile& file, const std::vector<MincAxis>& axes)
{
  VoxelLayout layout = { {}, ScalarTypeOf(file.kind, std::int64_t(file.valueBytes)) };
  for (std::size_t i = 0; i < 3; ++i)
  {
    layout.dimensions[i] = std::int64_t(axes[i].length);
  }
  if (IsComponents(file.axes.back()))
  {
    layout.componentCount = std::int64_t(file.axes.back().length);
  }
  if (layout.scalarType == VTK_VOID)
  {
    FailToRead(path, "numbers of 8 to 64 bits", std::to_string(8 * file.valueBytes) + " bits");
  }
  const double bytes = double(CheckedByteCount(path, layout));
  const double mostBytes =
    file.storedBytes * (file.isCompressed ? LargestRatio(Compression::Deflate) : 1.0);
  if (bytes > mostBytes)
  {
    FailToRead(path, ByteText(bytes) + " of voxels", ByteText(file.storedBytes));
  }
  return layout;
}

/// Geometry in RAS. The start of each axis is along its own direction.
ImageGeometry GeometryOf(const std::vector<MincAxis>& axes)
{
  ImageGeometry geometry;
  for (std::size_t i = 0; i < 3; ++i)
  {
    glm::dvec3 direction(0.0);
    direction[WorldAxis(axes[i])] = 1.0;
    direction = axes[i].cosines.value_or(direction);
    geometry.axesMm[int(i)] = direction * axes[i].stepMm;
    geometry.originMm += direction * axes[i].startMm;
  }
  return geometry;
}

/// True for an axis along which volumes follow each other.
bool IsOfVolumes(const MincAxis& axis)
{
  return WorldAxis(axis) < 0 && !IsComponents(axis);
}

/// The times of a file: seconds, if time is the only axis beside those of a volume.
VolumeTimes TimesOf(const MincFile& file)
{
  double count = 1.0;
  std::vector<MincAxis> others;
  for (const MincAxis& axis : file.axes)
  {
    if (IsOfVolumes(axis))
    {
      others.push_back(axis);
      count *= double(axis.length);
    }
  }
  const auto offered = std::int64_t(std::min(count, double(MostTimes)));
  const bool isTime = others.size() == 1 && others[0].name == "time" && !others[0].isIrregular;
  return isTime && others[0].hasStep ? EvenTimes(offered, others[0].startMm, others[0].stepMm)
                                     : NumberedTimes(offered);
}

/// The volume at one place of the dimensions that are slower, the last of which counts fastest.
MincPart VolumeAt(const MincFile& file, std::int64_t time)
{
  MincPart part;
  for (const MincAxis& axis : file.axes)
  {
    part.start.push_back(0);
    part.count.push_back(IsOfVolumes(axis) ? 1 : axis.length);
  }
  auto left = std::size_t(time);
  for (std::size_t i = file.axes.size(); i-- > 0;)
  {
    if (IsOfVolumes(file.axes[i]))
    {
      const std::size_t length = std::max<std::size_t>(file.axes[i].length, 1);
      part.start[i] = left % length;
      left /= length;
    }
  }
  return part;
}

vtkSmartPointer<vtkImageData> ReadSlices(
  MincFile& file, MincPart part, const VoxelLayout& layout, ReadProgress& progress)
{
  auto image = AllocatedImage(layout);
  const std::size_t slowest = file.axes.size() - 3 - (IsComponents(file.axes.back()) ? 1 : 0);
  const std::size_t sliceCount = part.count[slowest];
  part.count[slowest] = 1;
  for (std::size_t slice = 0; slice < sliceCount; ++slice)
  {
    progress.Report(double(slice) / double(sliceCount));
    part.start[slowest] = slice;
    file.ReadImage(part, image->GetScalarPointer(0, 0, int(slice)));
  }
  return image;
}

/// The stored values of the smallest and largest real value.
std::array<double, 2> ValidRange(const MincFile& file)
{
  const double count = std::pow(2.0, 8.0 * double(file.valueBytes));
  const bool isSigned = file.kind == NumberKind::Signed;
  return file.validRange.value_or(
    std::array<double, 2>{ isSigned ? -0.5 * count : 0.0, (isSigned ? 0.5 : 1.0) * count - 1.0 });
}

/// The maps to real values, of equal parts of the volume.
std::vector<Rescale> RescalesOf(const std::string& path, MincFile& file, MincPart part)
{
  if (file.kind == NumberKind::Float || !file.hasExtremes)
  {
    return { Rescale() };
  }
  const std::size_t spatialEnd = file.axes.size() - (IsComponents(file.axes.back()) ? 1 : 0);
  const std::array<double, 2> range = ValidRange(file);
  if (file.extremeRank >= spatialEnd || !(range[1] > range[0]))
  {
    FailToRead(path, "a valid range and extremes of slices or rows",
      "a range of " + std::to_string(range[1] - range[0]) + " and extremes along " +
        std::to_string(file.extremeRank) + " axes");
  }
  part.start.resize(file.extremeRank);
  part.count.resize(file.extremeRank);
  const std::vector<double> smallest = file.ReadExtremes("image-min", part);
  const std::vector<double> largest = file.ReadExtremes("image-max", part);
  std::vector<Rescale> rescales;
  for (std::size_t i = 0; i < smallest.size(); ++i)
  {
    const double slope = (largest[i] - smallest[i]) / (range[1] - range[0]);
    rescales.push_back({ slope, smallest[i] - slope * range[0] });
  }
  return rescales;
}

}

Volume ReadMinc(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const auto file = IsHdf5(FirstBytes(path)) ? OpenMinc2(path) : OpenMinc1(path);
  const std::vector<MincAxis> axes = SpatialAxes(path, *file);
  const VoxelLayout layout = LayoutOf(path, *file, axes);
  Volume volume;
  TakeTimes(path, TimesOf(*file), options, volume);
  const MincPart part = VolumeAt(*file, options.time);
  const std::vector<Rescale> rescales = RescalesOf(path, *file, part);
  volume.image = ReadSlices(*file, part, layout, progress);
  volume.image = Rescaled(path, volume.image, rescales);
  PlaceImage(path, InLps(GeometryOf(axes), LpsFromRas, 1.0), volume.image);
  return volume;
}

}
