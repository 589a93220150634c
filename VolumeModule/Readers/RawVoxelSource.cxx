#include "Readers/RawVoxelSource.h"

#include "Readers/FileError.h"

#include <vtkDataArray.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace varimarch
{

RawVoxelSource::RawVoxelSource(
  const std::string& path, const VoxelLayout& layout, std::uint64_t offset)
  : path(path)
  , offset(offset)
  , valueBytes(std::uint64_t(vtkDataArray::GetDataTypeSize(layout.scalarType)))
  , levels({ { layout.dimensions, { layout.dimensions[0], layout.dimensions[1], 1 },
      { 1.0, 1.0, 1.0 } } })
  , type(VoxelTypeOf(layout.scalarType).value())
  , descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
  if (this->descriptor < 0)
  {
    FailToRead(path, "a file that can be opened", std::strerror(errno));
  }
}

RawVoxelSource::~RawVoxelSource()
{
  close(this->descriptor);
}

void RawVoxelSource::ReadRun(std::uint64_t firstVoxel, std::uint64_t count, char* voxels) const
{
  std::uint64_t done = 0;
  const std::uint64_t wanted = count * this->valueBytes;
  while (done < wanted)
  {
    const ssize_t got = pread(this->descriptor, voxels + done, std::size_t(wanted - done),
      off_t(this->offset + firstVoxel * this->valueBytes + done));
    // The end of the file sets no error.
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      FailToRead(this->path,
        std::to_string(count) + " voxels from number " + std::to_string(firstVoxel),
        got == 0 ? "the end of the file" : std::strerror(errno));
    }
    done += std::uint64_t(std::max<ssize_t>(got, 0));
  }
}

BrickSource::Box RawVoxelSource::Occupied(const Box& box) const
{
  const auto& size = this->levels.front().dimensions;
  const auto byteOf = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    return off_t(this->offset + std::uint64_t((z * size[1] + y) * size[0] + x) * this->valueBytes);
  };
  const off_t begin = byteOf(box.lower[0], box.lower[1], box.lower[2]);
  const off_t end = byteOf(box.upper[0], box.upper[1] - 1, box.upper[2] - 1);
  const off_t data = lseek(this->descriptor, begin, SEEK_DATA);
  // There is no data behind a hole at the end of the file, nor behind the end.
  const bool isInHole =
    data < 0 ? errno == ENXIO && lseek(this->descriptor, 0, SEEK_END) >= end : data >= end;
  return isInHole ? Box{ box.lower, box.lower } : box;
}

// Reads runs of voxels that are adjacent in the file: of slices if the box has whole ones, else of
// rows.
void RawVoxelSource::Read(int, const Box& box, void* voxels) const
{
  const auto& size = this->levels.front().dimensions;
  const auto count = [&](int axis) { return std::uint64_t(box.upper[axis] - box.lower[axis]); };
  const bool hasWholeRows = std::int64_t(count(0)) == size[0];
  const bool hasWholeSlices = hasWholeRows && std::int64_t(count(1)) == size[1];
  const auto indexOf = [&](std::int64_t y, std::int64_t z)
  { return std::uint64_t((z * size[1] + y) * size[0] + box.lower[0]); };
  char* to = static_cast<char*>(voxels);
  const std::int64_t rowsAtOnce = hasWholeRows ? std::int64_t(count(1)) : 1;
  const std::int64_t slicesAtOnce = hasWholeSlices ? std::int64_t(count(2)) : 1;
  const std::uint64_t run = count(0) * std::uint64_t(rowsAtOnce) * std::uint64_t(slicesAtOnce);
  for (std::int64_t z = box.lower[2]; z < box.upper[2]; z += slicesAtOnce)
  {
    for (std::int64_t y = box.lower[1]; y < box.upper[1]; y += rowsAtOnce)
    {
      this->ReadRun(indexOf(y, z), run, to);
      to += run * this->valueBytes;
    }
  }
}

}
