// Volumes in HDF5: those of Imaris and of BigDataViewer, which have levels, and plain data sets, as
// ilastik, Fiji and h5py write them. See
// https://imaris.oxinst.com/support/imaris-file-format, https://imagej.net/plugins/bdv
#include "Readers/FileError.h"
#include "Readers/Pyramids/ArrayAxes.h"
#include "Readers/Pyramids/Hdf5File.h"
#include "Readers/Pyramids/Hdf5Layouts.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Times.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

/// A level as its file describes it.
struct Hdf5Level
{
  std::string dataSet;
  std::array<std::int64_t, 3> dimensions; ///< may be less than those of the data set
  ImageGeometry geometry;
  std::optional<ArraySelection> selection = {}; ///< the last three axes if there is none
};

/// The group in which ITK's HDF5ImageIO keeps an image.
constexpr const char* ItkGroup = "/ITKImage/0";

/// The last three axes of an array, of which the last is x, at the first place along others.
ArraySelection LastAxes(std::size_t rank)
{
  constexpr std::size_t None = ArraySelection::NoAxis;
  ArraySelection selection = { { None, None, None }, std::vector<std::int64_t>(rank, 0) };
  for (std::size_t axis = 0; axis < std::min<std::size_t>(rank, 3); ++axis)
  {
    selection.axes[axis] = rank - 1 - axis;
  }
  return selection;
}

class Hdf5Pyramid : public VoxelPyramid
{
public:
  Hdf5Pyramid(const std::string& path, const ReadOptions& options);

  std::int64_t Read(int level, const BrickSource::Box& box, void* voxels) override;
  StoredChunks Stored(int level) const override;

private:
  void TakeImaris();
  void TakeBigDataViewer();
  void TakeItk();
  void TakeDataSet(const std::string& name);
  void AddLevel(const Hdf5Level& level);
  void AddNamed(const std::string& name, const ArrayAxes& axes, const ImageGeometry* geometry);
  void NameOthers(const std::string& what, std::size_t count, std::size_t taken);
  std::size_t TimeToRead() const;
  std::vector<std::int64_t> AlongDataSet(std::size_t level,
    const std::array<std::int64_t, 3>& alongVolume, std::vector<std::int64_t> others) const;

  Hdf5Path path;
  std::unique_ptr<Hdf5File> file;
  std::size_t channel;
  std::int64_t wantedTime;
  std::vector<std::string> dataSets;      ///< one for each level
  std::vector<ArraySelection> selections; ///< the part of each data set that its level takes
};

Hdf5Pyramid::Hdf5Pyramid(const std::string& given, const ReadOptions& options)
  : path(Hdf5PathOf(FileOfBigDataViewer(given)))
  , file(std::make_unique<Hdf5File>(this->path.file))
  , channel(std::size_t(std::max(0, options.channel)))
  , wantedTime(options.time)
{
  if (!this->path.inner.empty())
  {
    this->TakeDataSet(this->path.inner);
  }
  else if (this->file->Has("/DataSet/ResolutionLevel 0/TimePoint 0/Channel 0/Data"))
  {
    this->TakeImaris();
  }
  else if (this->file->Has("/t00000/s00/0/cells"))
  {
    this->TakeBigDataViewer();
  }
  else if (this->file->Has(std::string(ItkGroup) + "/VoxelData"))
  {
    this->TakeItk();
  }
  else
  {
    this->TakeDataSet(LargestDataSet(*this->file));
  }
  SetScales(this->path.file, this->form);
}

void Hdf5Pyramid::NameOthers(const std::string& what, std::size_t count, std::size_t taken)
{
  if (taken >= std::max<std::size_t>(count, 1))
  {
    FailToRead(this->path.file, "one of " + std::to_string(count) + " " + what + ", counted from 0",
      "the wish for number " + std::to_string(taken));
  }
  if (count > 1)
  {
    this->form.otherChannels = "The file holds " + std::to_string(count) + " " + what +
      "; only that of number " + std::to_string(taken) + ", counted from 0, was read.";
  }
}

/// The number of the wanted time. Whoever asked for it refuses one that is not among those of the
/// form.
std::size_t Hdf5Pyramid::TimeToRead() const
{
  const auto last = std::int64_t(this->form.times.values.size()) - 1;
  return std::size_t(std::clamp<std::int64_t>(this->wantedTime, 0, last));
}

void Hdf5Pyramid::AddLevel(const Hdf5Level& level)
{
  const Hdf5Layout layout = LayoutOf(*this->file, level.dataSet);
  const bool isFirst = this->form.levels.empty();
  const std::size_t rank = layout.size.size();
  const bool isVolume = rank >= 2 && layout.scalarType != VTK_VOID;
  if (!isVolume || (!isFirst && layout.scalarType != this->form.scalarType))
  {
    FailToRead(this->path.file,
      "numbers of at most 64 bits, of one type, with at least two axes in " +
        Quoted(level.dataSet, 80),
      "values of another kind or " + std::to_string(rank) + " axes");
  }
  BrickSource::Level bricks = { { 1, 1, 1 }, { 1, 1, 1 }, { 1.0, 1.0, 1.0 } };
  const ArraySelection selection = level.selection.value_or(LastAxes(rank));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = selection.axes[axis];
    if (place == ArraySelection::NoAxis)
    {
      continue;
    }
    const std::int64_t size = layout.size[place];
    const std::int64_t wanted = level.dimensions[axis];
    bricks.dimensions[axis] = wanted > 0 ? std::min(wanted, size) : size;
    bricks.chunk[axis] = std::min(bricks.dimensions[axis], layout.chunk[place]);
    if (size < 1)
    {
      FailToRead(this->path.file, "at least one voxel in " + Quoted(level.dataSet, 80), "none");
    }
  }
  if (!layout.isCompressed && layout.neededBytes > layout.storedBytes && layout.storedBytes > 0.0)
  {
    FailToRead(
      this->path.file, ByteText(layout.neededBytes) + " of voxels", ByteText(layout.storedBytes));
  }
  this->form.scalarType = layout.scalarType;
  this->form.levels.push_back(bricks);
  this->form.geometries.push_back(level.geometry);
  this->dataSets.push_back(level.dataSet);
  this->selections.push_back(selection);
}

/// A name such as "/s07".
std::string NameOfNumber(const std::string& prefix, std::size_t number, std::size_t digits)
{
  const std::string text = std::to_string(number);
  return prefix + std::string(digits - std::min(digits, text.size()), '0') + text;
}

/// The number of groups with such names from 0.
std::size_t CountOfNames(const Hdf5File& file, const std::string& prefix, std::size_t digits)
{
  std::size_t count = 0;
  while (file.Has(NameOfNumber(prefix, count, digits)))
  {
    ++count;
  }
  return count;
}

void Hdf5Pyramid::TakeImaris()
{
  const ImarisBox box = ImarisBoxOf(*this->file, this->form.warnings);
  this->form.warnings.push_back(UnknownSides);
  const std::string first = "/DataSet/ResolutionLevel 0";
  this->form.times = ImarisTimes(*this->file, this->file->Count(first + "/TimePoint %"));
  this->NameOthers("channels", this->file->Count(first + "/TimePoint 0/Channel %"), this->channel);
  this->form.channels =
    ImarisChannels(*this->file, this->file->Count(first + "/TimePoint 0/Channel %"));
  const std::size_t count = this->file->Count("/DataSet/ResolutionLevel %");
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string group = "/DataSet/ResolutionLevel " + std::to_string(i) + "/TimePoint " +
      std::to_string(this->TimeToRead()) + "/Channel " + std::to_string(this->channel);
    const std::array<std::int64_t, 3> dimensions = ImarisDimensions(*this->file, group);
    this->AddLevel({ group + "/Data", dimensions, ImarisGeometry(box, dimensions) });
  }
}

void Hdf5Pyramid::TakeBigDataViewer()
{
  const glm::dvec3 stepMm =
    BigDataViewerVoxelMm(this->path.file, this->channel, this->form.warnings);
  this->form.warnings.push_back(UnknownSides);
  this->form.times = NumberedTimes(std::int64_t(CountOfNames(*this->file, "/t", 5)));
  this->NameOthers("setups", CountOfNames(*this->file, "/s", 2), this->channel);
  const std::string setup = NameOfNumber("/s", this->channel, 2);
  const std::string time = NameOfNumber("/t", this->TimeToRead(), 5);
  const std::vector<double> factors = this->file->Numbers(setup + "/resolutions");
  const std::size_t count = this->file->Count(time + setup + "/%/cells");
  if (count < 1 || factors.size() != 3 * count)
  {
    FailToRead(this->path.file,
      "a factor along each axis for " + std::to_string(count) + " levels in " + setup +
        "/resolutions",
      std::to_string(factors.size()) + " numbers");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    Hdf5Level level = { time + setup + "/" + std::to_string(i) + "/cells", {}, {} };
    for (int axis = 0; axis < 3; ++axis)
    {
      // A coarse voxel is the mean of as many fine ones, and lies in their middle.
      const double factor = factors[3 * i + std::size_t(axis)];
      level.geometry.axesMm[axis] = glm::dvec3(0.0);
      level.geometry.axesMm[axis][axis] = stepMm[axis] * factor;
      level.geometry.originMm[axis] = 0.5 * (factor - 1.0) * stepMm[axis];
    }
    this->AddLevel(level);
  }
  // The files have the bits of unsigned numbers in a signed type, since Java has no unsigned one.
  if (this->form.scalarType == VTK_SHORT)
  {
    this->form.scalarType = VTK_UNSIGNED_SHORT;
  }
}

/// Adds a data set as the only level.
/// @param geometry  null if the axes say it
void Hdf5Pyramid::AddNamed(
  const std::string& name, const ArrayAxes& axes, const ImageGeometry* geometry)
{
  const std::vector<std::int64_t> shape = LayoutOf(*this->file, name).size;
  DescribeAxes(axes, shape, int(this->channel), this->form);
  ReadOptions options;
  options.channel = int(this->channel);
  options.time = std::int64_t(this->TimeToRead());
  const ArraySelection selection = SelectionOf(this->path.file, axes, shape, false, options);
  this->AddLevel({ name, {}, geometry ? *geometry : GeometryOf(axes, selection), selection });
}

void Hdf5Pyramid::TakeDataSet(const std::string& name)
{
  this->AddNamed(name, AxesOfDataSet(*this->file, name, this->form.warnings), nullptr);
  const auto number = [&](const char* attribute) -> std::optional<double>
  {
    const std::vector<double> numbers = this->file->NumberAttribute(name, attribute);
    return numbers.size() == 1 ? std::optional(numbers.front()) : std::nullopt;
  };
  WarnOfScale(number("scale_factor"), number("add_offset"), this->form.warnings);
  this->form.warnings.push_back(UnknownSides);
  const std::size_t count = this->file->DataSets().size();
  if (count > 1 && this->path.inner.empty())
  {
    this->form.warnings.push_back("The file holds " + std::to_string(count) +
      " data sets; only the largest, " + name + ", was read (another is opened as " +
      this->path.file + "/NAME).");
  }
}

/// Takes an image of ITK, whose axes lie in LPS: a row of the directions for each.
void Hdf5Pyramid::TakeItk()
{
  const std::string group = ItkGroup;
  const std::string voxels = group + "/VoxelData";
  const std::vector<double> spacing = this->file->Numbers(group + "/Spacing");
  const std::vector<double> origin = this->file->Numbers(group + "/Origin");
  const std::vector<double> directions = this->file->Numbers(group + "/Directions");
  if (spacing.size() != 3 || origin.size() != 3 || directions.size() != 9)
  {
    this->TakeDataSet(voxels);
    return;
  }
  ImageGeometry geometry;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    geometry.originMm[int(axis)] = origin[axis];
    geometry.axesMm[int(axis)] = spacing[axis] * glm::make_vec3(directions.data() + 3 * axis);
  }
  std::vector<std::string> names = { "z", "y", "x" };
  names.resize(std::max<std::size_t>(3, LayoutOf(*this->file, voxels).size.size()), "channel");
  this->AddNamed(voxels, AxesNamed(this->path.file, names), &geometry);
}

/// Numbers for the axes of a data set, slowest first.
/// @param others  the numbers for axes that the volume does not have
std::vector<std::int64_t> Hdf5Pyramid::AlongDataSet(std::size_t level,
  const std::array<std::int64_t, 3>& alongVolume, std::vector<std::int64_t> others) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = this->selections[level].axes[axis];
    if (place != ArraySelection::NoAxis)
    {
      others[place] = alongVolume[axis];
    }
  }
  return others;
}

StoredChunks Hdf5Pyramid::Stored(int number) const
{
  const auto level = std::size_t(number);
  const BrickSource::Level& form = this->form.levels[level];
  const std::array<std::int64_t, 3> count = ChunkCount(form);
  const std::int64_t slices = count[0] * count[1];
  std::vector<std::vector<std::int64_t>> starts;
  const bool areFew = double(slices) * double(count[2]) <= MostChunksToFind;
  for (std::int64_t i = 0; areFew && i < slices * count[2]; ++i)
  {
    const std::array<std::int64_t, 3> place = { i % count[0], i / count[0] % count[1], i / slices };
    starts.push_back(this->AlongDataSet(level,
      { place[0] * form.chunk[0], place[1] * form.chunk[1], place[2] * form.chunk[2] },
      this->selections[level].start));
  }
  const Hdf5Chunks chunks = ChunksOf(*this->file, this->dataSets[level], starts);
  const auto written = fs::last_write_time(this->path.file).time_since_epoch().count();
  return { chunks.areThere, ValueIn(chunks.fill, this->form.scalarType),
    std::to_string(fs::file_size(this->path.file)) + " bytes of " + std::to_string(written) };
}

std::int64_t Hdf5Pyramid::Read(int number, const BrickSource::Box& box, void* voxels)
{
  const auto level = std::size_t(number);
  const std::vector<std::int64_t>& start = this->selections[level].start;
  ReadHdf5Box(*this->file, this->dataSets[level], this->AlongDataSet(level, box.lower, start),
    this->AlongDataSet(level, SizeOf(box), std::vector<std::int64_t>(start.size(), 1)), voxels);
  return 0;
}

}

std::unique_ptr<VoxelPyramid> OpenHdf5(const std::string& path, const ReadOptions& options)
{
  return std::make_unique<Hdf5Pyramid>(path, options);
}

}
