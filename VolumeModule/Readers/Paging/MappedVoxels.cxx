#include "Readers/Paging/MappedVoxels.h"

#include "Core/Blocks/BrickSource.h"
#include "Readers/FileError.h"
#include "Readers/Paging/MappedMemory.h"
#include "Readers/Paging/PagedVoxels.h"
#include "Readers/Paging/Preview.h"
#include "Readers/Paging/SummaryFile.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{
namespace
{

/// Only atomic numbers, since a signal's action may interrupt anything.
struct GuardedPages
{
  std::atomic<std::uintptr_t> begin = 0;
  std::atomic<std::uintptr_t> end = 0; ///< 0: not in use
  std::atomic<int> descriptor = -1;
  std::atomic<std::size_t> offset = 0;
  std::atomic<bool> replaced = false;
};

constexpr std::size_t MostGuards = 256;

std::array<GuardedPages, MostGuards> guards;

struct sigaction actionBefore = {};

std::uintptr_t pageSize = 4096;

GuardedPages* GuardOf(std::uintptr_t address)
{
  const auto guard = std::find_if(guards.begin(), guards.end(),
    [&](const GuardedPages& pages) { return address >= pages.begin && address < pages.end; });
  return guard == guards.end() ? nullptr : guard;
}

/// Replaces all pages that a shortened file has lost, or else the one that cannot be read. Calls
/// only functions that are safe in the action of a signal.
bool ReplacePages(GuardedPages& guard, std::uintptr_t address)
{
  const std::uintptr_t page = address / pageSize * pageSize;
  std::uintptr_t from = page;
  std::uintptr_t to = page + pageSize;
  struct stat status = {};
  const bool isKnown = fstat(guard.descriptor, &status) == 0;
  const std::uintptr_t pagesOfFile = (std::uintptr_t(status.st_size) + pageSize - 1) / pageSize;
  const std::uintptr_t firstLost =
    guard.begin + (std::max<std::uintptr_t>(pagesOfFile * pageSize, guard.offset) - guard.offset);
  if (isKnown && firstLost <= page)
  {
    from = firstLost;
    to = guard.end;
  }
  guard.replaced = true;
  return mmap(reinterpret_cast<void*>(from), to - from, PROT_READ | PROT_WRITE,
           MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0) != MAP_FAILED;
}

/// An action that ends after restoring the earlier one lets the program meet the same fault again,
/// which then has its usual effect. A signal that another program sent has no address, and would
/// not come again by itself.
void ActOnSignal(int signal, siginfo_t* info, void*)
{
  const int errorBefore = errno;
  const bool isFault = info->si_code > 0;
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  GuardedPages* const guard = isFault ? GuardOf(address) : nullptr;
  if (!guard || !ReplacePages(*guard, address))
  {
    sigaction(signal, &actionBefore, nullptr);
    if (!isFault)
    {
      raise(signal);
    }
  }
  errno = errorBefore;
}

void TakeOverSignal()
{
  pageSize = std::uintptr_t(sysconf(_SC_PAGESIZE));
  struct sigaction action = {};
  action.sa_sigaction = ActOnSignal;
  action.sa_flags = SA_SIGINFO | SA_RESTART | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(SIGBUS, &action, &actionBefore);
}

/// Guards addresses. Pages that cannot be read are replaced by pages of zeros.
/// @param descriptor  the file that is mapped there, open until GuardNoMore
/// @param offset      offset in the file of the first page
/// @return the number of the guard; -1 if there are too many
int GuardPages(char* pages, std::size_t byteCount, int descriptor, std::size_t offset)
{
  static std::once_flag once;
  static std::mutex mutex;
  std::call_once(once, TakeOverSignal);
  const std::lock_guard<std::mutex> lock(mutex);
  const auto guard = std::find_if(
    guards.begin(), guards.end(), [](const GuardedPages& candidate) { return candidate.end == 0; });
  if (guard == guards.end())
  {
    return -1;
  }
  guard->descriptor = descriptor;
  guard->offset = offset;
  guard->replaced = false;
  guard->begin = reinterpret_cast<std::uintptr_t>(pages);
  guard->end = reinterpret_cast<std::uintptr_t>(pages) + byteCount;
  return int(guard - guards.begin());
}

/// True if a page was replaced.
bool HasReplacedPages(int guard)
{
  return guards[std::size_t(guard)].replaced;
}

void GuardNoMore(int guard)
{
  guards[std::size_t(guard)].end = 0;
}

/// The bytes of a file in the address space, read from disk when they are touched. They may be
/// written; what is written stays in memory and never reaches the file.
///
/// Bytes that the file has lost since, because it was made shorter or its disk fails, are 0 instead
/// of ending the program; Problem() then says so.
class MappedFile : public PagedVoxels
{
public:
  /// @param offset  first byte of the file
  /// @throws std::runtime_error if the file is shorter, or cannot be mapped
  MappedFile(const std::string& path, std::uint64_t offset, std::uint64_t byteCount);
  ~MappedFile() override;

  std::string Problem() const override;
  bool AreInForkedProcesses() const override { return true; }
  std::vector<Part> DroppableParts(const PageMap& map, std::uint64_t now) override;
  std::size_t Drop(std::size_t index, const PageMap& map) override;

private:
  static constexpr std::size_t PartBytes = 4 << 20;
  /// The looks that see all parts once. Rays wait while parts are looked at, which takes longer
  /// than dropping them, so that a look is at every fourth part.
  static constexpr std::size_t LooksPerRound = 4;

  /// Memory of a part as PageMap::DroppableBytes has it, when it was last looked at.
  struct Look
  {
    std::size_t residentBytes = 0;
    std::uint64_t grew = 0;
  };

  std::size_t BytesOfPart(std::size_t index) const;

  std::string path;
  std::uint64_t size = 0; ///< size of the file when it was mapped
  std::int64_t modified = 0;
  int descriptor = -1;
  std::vector<Look> looks; ///< one for each part
  std::size_t nextLook = 0;
  int guard = -1; ///< number of its entry among the guarded addresses
};

std::int64_t NanosecondsOf(const timespec& time)
{
  return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

MappedFile::MappedFile(const std::string& path, std::uint64_t offset, std::uint64_t byteCount)
  : path(path)
  , size(ReadableFileSize(path))
{
  if (offset + byteCount > this->size)
  {
    FailToRead(path, std::to_string(offset + byteCount) + " bytes", std::to_string(this->size));
  }
  this->descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status = {};
  if (this->descriptor < 0 || fstat(this->descriptor, &status) != 0)
  {
    FailToRead(path, "a file that can be opened", std::strerror(errno));
  }
  this->modified = NanosecondsOf(status.st_mtim);
  const std::uint64_t page = PageBytes();
  this->lead = std::size_t(offset % page);
  this->pageBytes = (std::size_t(byteCount) + this->lead + page - 1) / page * page;
  void* const mapped = mmap(nullptr, this->pageBytes, PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_NORESERVE, this->descriptor, off_t(offset - this->lead));
  this->pages = static_cast<char*>(mapped);
  this->guard = mapped == MAP_FAILED
    ? -1
    : GuardPages(this->pages, this->pageBytes, this->descriptor, std::size_t(offset - this->lead));
  if (this->guard < 0)
  {
    const std::string reason = mapped == MAP_FAILED ? std::strerror(errno) : "too many others";
    if (mapped != MAP_FAILED)
    {
      munmap(mapped, this->pageBytes);
    }
    close(this->descriptor);
    FailToRead(
      path, "a file whose " + ByteText(double(byteCount)) + " of voxels can be mapped", reason);
  }
  this->looks.resize((this->pageBytes + PartBytes - 1) / PartBytes);
}

MappedFile::~MappedFile()
{
  GuardNoMore(this->guard);
  munmap(this->pages, this->pageBytes);
  close(this->descriptor);
}

std::size_t MappedFile::BytesOfPart(std::size_t index) const
{
  return std::min(PartBytes, this->pageBytes - index * PartBytes);
}

std::vector<PagedVoxels::Part> MappedFile::DroppableParts(const PageMap& map, std::uint64_t now)
{
  std::vector<Part> parts;
  this->nextLook = (this->nextLook + 1) % LooksPerRound;
  for (std::size_t i = this->nextLook; i < this->looks.size(); i += LooksPerRound)
  {
    Look& look = this->looks[i];
    const std::size_t resident =
      map.DroppableBytes(this->pages + i * PartBytes, this->BytesOfPart(i));
    look.grew = resident > look.residentBytes ? now : look.grew;
    look.residentBytes = resident;
    if (resident > 0)
    {
      parts.push_back({ i, resident, look.grew });
    }
  }
  return parts;
}

// The part may have been written since the look at all of them, which takes a while.
std::size_t MappedFile::Drop(std::size_t index, const PageMap& map)
{
  char* const begin = this->pages + index * PartBytes;
  const std::size_t bytes = map.DroppableBytes(begin, this->BytesOfPart(index));
  if (bytes > 0)
  {
    madvise(begin, this->BytesOfPart(index), MADV_DONTNEED);
  }
  return bytes;
}

std::string MappedFile::Problem() const
{
  const std::string begin = "The file " + Quoted(this->path, 200);
  struct stat status = {};
  const bool isKnown = fstat(this->descriptor, &status) == 0;
  if (isKnown && std::uint64_t(status.st_size) < this->size)
  {
    return begin + " was made shorter while it is drawn from disk: expected " +
      std::to_string(this->size) + " bytes, found " + std::to_string(status.st_size) +
      "; voxels that are missing count as 0. Open it again when it is complete";
  }
  if (HasReplacedPages(this->guard))
  {
    return begin +
      " could not be read everywhere: voxels that are missing count as 0. Check its "
      "disk, and open it again";
  }
  if (!isKnown || NanosecondsOf(status.st_mtim) != this->modified)
  {
    return begin +
      " was changed while it is drawn from disk, so that the image may mix old and "
      "new voxels. Open it again";
  }
  return "";
}

/// The voxels of a file that has them as they are in memory, one after the other.
class RawVoxelSource : public BrickSource
{
public:
  /// @param layout  one component of a type of VoxelTypeOf
  /// @param offset  offset of the first voxel in the file
  /// @throws std::runtime_error if the file cannot be opened
  RawVoxelSource(const std::string& path, const VoxelLayout& layout, std::uint64_t offset);
  ~RawVoxelSource() override;
  RawVoxelSource(const RawVoxelSource&) = delete;
  RawVoxelSource& operator=(const RawVoxelSource&) = delete;

  const std::vector<Level>& Levels() const override { return this->levels; }
  VoxelType Type() const override { return this->type; }
  void Read(int level, const Box& box, void* voxels) const override;
  /// Holes of a sparse file are not read.
  Box Occupied(const Box& box) const override;

private:
  void ReadRun(std::uint64_t firstVoxel, std::uint64_t count, char* voxels) const;

  std::string path;
  std::uint64_t offset;
  std::uint64_t valueBytes;
  std::vector<Level> levels;
  VoxelType type;
  int descriptor;
};

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

std::string ObstacleToMapping(
  const VoxelFile& file, const VoxelLayout& layout, std::uint64_t offset)
{
  const auto valueBytes = std::uint64_t(vtkDataArray::GetDataTypeSize(layout.scalarType));
  if (file.compression != Compression::None)
  {
    return "are compressed";
  }
  if (file.encoding == VoxelEncoding::Text)
  {
    return "are written as text";
  }
  if (layout.componentCount != 1 || !VoxelTypeOf(layout.scalarType))
  {
    return "are not single numbers of 8 bits, 16 bits or type float";
  }
  if (valueBytes > 1 && file.bigEndian != HostIsBigEndian)
  {
    return "are in another byte order than this machine's";
  }
  if (file.paths.size() > 1 || file.alternation > 0)
  {
    return "are in several pieces";
  }
  if (!file.conversion.empty())
  {
    return "are " + file.conversion;
  }
  return offset % valueBytes != 0 ? "begin at byte " + std::to_string(offset) +
      ", which is no multiple of their " + std::to_string(valueBytes) + " bytes"
                                  : "";
}

vtkSmartPointer<vtkImageData> MappedImage(const VoxelsInFile& voxels, ReadProgress& progress)
{
  const VoxelLayout& layout = voxels.layout;
  auto file =
    std::make_unique<MappedFile>(voxels.path, voxels.offset, ByteCountOf(voxels.path, layout));
  const RawVoxelSource source(voxels.path, layout, voxels.offset);
  const std::uint64_t mostBytes = voxels.mapping.mostMemoryBytes;
  const SummarizedVoxels summarized = { source, layout.scalarType, voxels.path, voxels.path,
    StampOfFile(voxels.path, voxels.offset), mostBytes,
    SideOfBricks(source.Levels().front(), source.Type(), mostBytes / 2) };
  std::shared_ptr<const VolumeSummary> summary = KeptSummary(summarized);
  if (!summary && voxels.mapping.preview && NeedsMuchReading(summarized))
  {
    return CoarseCopy(source, layout, voxels.mapping, progress);
  }
  summary = summary ? summary : MadeSummary(summarized, progress);
  return PagedImage(std::move(file), layout, summary, mostBytes);
}

vtkSmartPointer<vtkImageData> PagedImage(std::unique_ptr<PagedVoxels> voxels,
  const VoxelLayout& layout, std::shared_ptr<const VolumeSummary> summary, std::uint64_t mostBytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(
    int(layout.dimensions[0]), int(layout.dimensions[1]), int(layout.dimensions[2]));
  const auto scalars =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layout.scalarType));
  void* const bytes = KeepPaged(std::move(voxels), mostBytes);
  scalars->SetVoidArray(
    bytes, image->GetNumberOfPoints(), 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  scalars->SetArrayFreeFunction(ReleasePaged);
  scalars->SetName("scalars");
  PagedVoxelsAt(bytes)->Describe(std::move(summary), scalars->GetMTime());
  image->GetPointData()->SetScalars(scalars);
  return image;
}

}
