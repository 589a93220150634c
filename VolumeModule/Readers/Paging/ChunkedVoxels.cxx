#include "Readers/Paging/ChunkedVoxels.h"

#include "Core/Fields/VolumeSummary.h"
#include "Readers/FileError.h"
#include "Readers/Paging/MappedMemory.h"
#include "Readers/VoxelLayout.h"

#include <fcntl.h>
#include <linux/userfaultfd.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <utility>

namespace varimarch
{
namespace
{

/// Calls take(first, number behind the last, kind) for each run of numbers below `count` that are
/// of one kind.
template <class KindOf, class Take>
void EachRun(std::size_t count, KindOf kindOf, Take take)
{
  for (std::size_t begin = 0; begin < count;)
  {
    const auto kind = kindOf(begin);
    std::size_t end = begin + 1;
    while (end < count && kindOf(end) == kind)
    {
      ++end;
    }
    take(begin, end, kind);
    begin = end;
  }
}

/// A descriptor of faults, those of system calls too where the user may have them; -1 with errno if
/// the system refuses.
int OpenFaults()
{
  constexpr int Flags = O_CLOEXEC | O_NONBLOCK;
  auto descriptor = int(syscall(SYS_userfaultfd, Flags));
  if (descriptor < 0)
  {
    descriptor = int(syscall(SYS_userfaultfd, Flags | UFFD_USER_MODE_ONLY));
  }
  uffdio_api wanted = {};
  wanted.api = UFFD_API;
  wanted.features = UFFD_FEATURE_PAGEFAULT_FLAG_WP;
  const bool isRefused = descriptor >= 0 && ioctl(descriptor, UFFDIO_API, &wanted) != 0;
  const bool hasWrites = (wanted.features & UFFD_FEATURE_PAGEFAULT_FLAG_WP) != 0;
  if (descriptor >= 0 && (isRefused || !hasWrites))
  {
    const int reason = isRefused ? errno : ENOTSUP; // some processors' kernels lack them
    close(descriptor);
    errno = reason;
    return -1;
  }
  return descriptor;
}

std::uint64_t Number(const char* address)
{
  return reinterpret_cast<std::uintptr_t>(address);
}

/// Asks the system for pages until all are there. It breaks off while others change the address
/// space, and where memory is short, of which MappedMemory then drops some.
/// @param ask  (first byte); returns the bytes that are done, or a negative number of an error
template <class Ask>
void PutAll(std::size_t byteCount, Ask ask)
{
  for (std::size_t from = 0; from < byteCount;)
  {
    const std::int64_t done = ask(from);
    if (done == -ENOMEM)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    // A page that is there already, or whose addresses are gone, is left alone.
    const bool isRepeated = done == -ENOMEM || done == -EAGAIN;
    from += done > 0 ? std::size_t(done) : isRepeated ? 0 : PageBytes();
  }
}

std::int64_t DoneOrError(int result, std::int64_t done)
{
  return result == 0 || done > 0 ? done : -std::int64_t(errno);
}

}

const std::string& PageFaults::Obstacle()
{
  static const std::string obstacle = []() -> std::string
  {
    const int descriptor = OpenFaults();
    if (descriptor < 0)
    {
      return std::string("the system refuses userfaultfd (") + std::strerror(errno) + ")";
    }
    close(descriptor);
    return "";
  }();
  return obstacle;
}

PageFaults::PageFaults(char* pages, std::size_t byteCount)
  : faults(OpenFaults())
  , stop(eventfd(0, EFD_CLOEXEC))
{
  uffdio_register wanted = {};
  wanted.range = { Number(pages), byteCount };
  wanted.mode = UFFDIO_REGISTER_MODE_MISSING | UFFDIO_REGISTER_MODE_WP;
  if (this->faults < 0 || this->stop < 0 || ioctl(this->faults, UFFDIO_REGISTER, &wanted) != 0)
  {
    const std::string reason = std::strerror(errno);
    close(this->faults);
    close(this->stop);
    throw std::runtime_error("the system refuses to report page faults (" + reason + ")");
  }
}

PageFaults::~PageFaults()
{
  close(this->faults);
  close(this->stop);
}

std::optional<PageFaults::Fault> PageFaults::Next()
{
  std::array<pollfd, 2> sources = { { { this->stop, POLLIN, 0 }, { this->faults, POLLIN, 0 } } };
  for (;;)
  {
    poll(sources.data(), sources.size(), -1);
    if (sources[0].revents != 0)
    {
      return std::nullopt;
    }
    uffd_msg message = {};
    const bool isFault =
      read(this->faults, &message, sizeof(message)) == ssize_t(sizeof(message)) &&
      message.event == UFFD_EVENT_PAGEFAULT;
    if (isFault)
    {
      const std::uint64_t page = message.arg.pagefault.address / PageBytes() * PageBytes();
      return Fault{ reinterpret_cast<char*>(std::uintptr_t(page)),
        (message.arg.pagefault.flags & UFFD_PAGEFAULT_FLAG_WP) != 0 };
    }
  }
}

void PageFaults::Stop()
{
  eventfd_write(this->stop, 1);
}

void PageFaults::Put(char* pages, const char* bytes, std::size_t byteCount)
{
  PutAll(byteCount,
    [&](std::size_t from)
    {
      uffdio_copy copy = {};
      copy.dst = Number(pages + from);
      copy.src = Number(bytes + from);
      copy.len = byteCount - from;
      copy.mode = UFFDIO_COPY_MODE_WP;
      const int result = ioctl(this->faults, UFFDIO_COPY, &copy);
      return DoneOrError(result, copy.copy);
    });
}

void PageFaults::PutZeros(char* pages, std::size_t byteCount)
{
  PutAll(byteCount,
    [&](std::size_t from)
    {
      uffdio_zeropage zeros = {};
      zeros.range = { Number(pages + from), byteCount - from };
      const int result = ioctl(this->faults, UFFDIO_ZEROPAGE, &zeros);
      return DoneOrError(result, zeros.zeropage);
    });
}

void PageFaults::Wake(char* page)
{
  uffdio_range range = { Number(page), PageBytes() };
  ioctl(this->faults, UFFDIO_WAKE, &range);
}

void PageFaults::AllowWriting(char* page)
{
  uffdio_writeprotect allowed = {};
  allowed.range = { Number(page), PageBytes() };
  ioctl(this->faults, UFFDIO_WRITEPROTECT, &allowed);
}

namespace
{

std::size_t BytesOfVoxel(VoxelType type)
{
  return ByVoxelType(type, [](auto voxel) { return sizeof(voxel); });
}

std::uint64_t TimeNow()
{
  return std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count());
}

bool IsEmpty(const BrickSource::Box& box)
{
  return box.lower[0] >= box.upper[0];
}

/// The size of units that do not need a decoder each few rows, of which the memory has many.
double WantedUnitBytes(std::uint64_t mostMemoryBytes)
{
  return std::min(16e6, double(mostMemoryBytes) / 256.0);
}

/// The number of units that a part of the memory has room for: at least 1, and at most some for
/// each thread that may wait for voxels.
std::size_t UnitsIn(double memoryBytes, std::uint64_t unitBytes, int mostPerThread)
{
  const double most = double(mostPerThread) * double(tbb::this_task_arena::max_concurrency());
  return std::size_t(std::clamp(memoryBytes / double(unitBytes), 1.0, most));
}

bool IsPageOfZeros(const char* page)
{
  static const std::vector<char> zeros(PageBytes());
  return std::memcmp(page, zeros.data(), zeros.size()) == 0;
}

/// The bytes of a slice of a box that is in memory; 0 without voxels.
std::size_t BytesOfSlice(const std::vector<char>& voxels, const BrickSource::Box& box)
{
  return voxels.size() / std::size_t(box.upper[2] - box.lower[2]);
}

}

std::string ChunkedVoxels::Obstacle(
  const BrickSource::Level& level, std::size_t voxelBytes, std::uint64_t mostMemoryBytes)
{
  if (!PageFaults::Obstacle().empty())
  {
    return "cannot be read when they are needed, since " + PageFaults::Obstacle();
  }
  if (!VoxelUnits::AreIn(level, voxelBytes, PageBytes()))
  {
    return "are in slices of less than two pages of memory";
  }
  const double unitBytes = double(
    VoxelUnits(level, voxelBytes, PageBytes(), WantedUnitBytes(mostMemoryBytes)).MostBytes());
  constexpr double MostPart = 1.0 / 8.0;
  return unitBytes > MostPart * double(mostMemoryBytes)
    ? "are in chunks of which a row needs " + ByteText(unitBytes)
    : "";
}

ChunkedVoxels::ChunkedVoxels(std::unique_ptr<const BrickSource> newSource,
  std::shared_ptr<const VolumeSummary> newSummary, const std::string& path,
  std::uint64_t mostMemoryBytes)
  : source(std::move(newSource))
  , summary(std::move(newSummary))
  , voxelBytes(BytesOfVoxel(this->source->Type()))
  , units(this->source->Levels().front(), this->voxelBytes, PageBytes(),
      WantedUnitBytes(mostMemoryBytes))
  , unitsToKeep(UnitsIn(double(mostMemoryBytes) / 4.0, this->units.MostBytes(), 2))
  , states(this->units.Count())
{
  const auto& size = this->source->Levels().front().dimensions;
  const std::uint64_t page = PageBytes();
  this->pageBytes =
    (this->units.RowBytes() * std::uint64_t(size[1] * size[2]) + page - 1) / page * page;
  void* const addresses = mmap(nullptr, this->pageBytes, PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (addresses == MAP_FAILED)
  {
    FailToRead(path, "addresses for " + ByteText(double(this->pageBytes)) + " of voxels",
      std::strerror(errno));
  }
  this->pages = static_cast<char*>(addresses);
  // A process that is forked would find zeros there instead of voxels.
  madvise(addresses, this->pageBytes, MADV_DONTFORK);
  madvise(addresses, this->pageBytes, MADV_NOHUGEPAGE);
  try
  {
    this->faults.emplace(this->pages, this->pageBytes);
    // They have units of their own while they read.
    const std::size_t servers = UnitsIn(double(mostMemoryBytes) / 16.0, this->units.MostBytes(), 1);
    while (this->servers.size() < servers)
    {
      this->servers.emplace_back([this] { this->Serve(); });
    }
  }
  catch (const std::exception& error)
  {
    this->Stop();
    munmap(this->pages, this->pageBytes);
    FailToRead(path, "voxels that are read when they are needed", error.what());
  }
}

ChunkedVoxels::~ChunkedVoxels()
{
  this->Stop();
  munmap(this->pages, this->pageBytes);
}

void ChunkedVoxels::Stop()
{
  if (this->faults)
  {
    this->faults->Stop();
  }
  for (std::thread& server : this->servers)
  {
    server.join();
  }
  this->faults.reset();
}

std::string ChunkedVoxels::Problem() const
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return this->problem;
}

std::vector<PagedVoxels::Part> ChunkedVoxels::DroppableParts(const PageMap&, std::uint64_t)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < this->states.size(); ++i)
  {
    const Unit& unit = this->states[i];
    if (unit.state == State::There && !unit.isWritten && unit.droppableBytes > 0)
    {
      parts.push_back({ i, unit.droppableBytes, unit.readAt });
    }
  }
  // Whoever waited for the newest may not have gone on yet: dropped at once, they would be read
  // again and again.
  const auto newest = parts.end() - std::ptrdiff_t(std::min(parts.size(), this->unitsToKeep));
  std::nth_element(parts.begin(), newest, parts.end(),
    [](const Part& one, const Part& other) { return one.grew < other.grew; });
  parts.erase(newest, parts.end());
  return parts;
}

std::size_t ChunkedVoxels::Drop(std::size_t index, const PageMap&)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  Unit& unit = this->states[index];
  if (unit.state != State::There || unit.isWritten || unit.droppableBytes == 0)
  {
    return 0;
  }
  for (const Pages& pages : this->PagesOf(index))
  {
    EachRun(
      pages.count, [&](std::size_t page) -> bool { return unit.areZeros[pages.first + page]; },
      [&](std::size_t begin, std::size_t end, bool areZeros)
      {
        if (!areZeros)
        {
          madvise(pages.bytes + begin * PageBytes(), (end - begin) * PageBytes(), MADV_DONTNEED);
        }
      });
  }
  unit.state = State::Missing;
  return unit.droppableBytes;
}

std::vector<ChunkedVoxels::Pages> ChunkedVoxels::PagesOf(std::size_t unit) const
{
  const BrickSource::Box box = this->units.BoxOf(unit);
  std::vector<Pages> all;
  std::size_t first = 0;
  for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
  {
    const VoxelUnits::Run run = this->units.RunOf(unit, slice);
    all.push_back({ this->pages + run.begin, first, (run.end - run.begin) / PageBytes() });
    first += all.back().count;
  }
  return all;
}

void ChunkedVoxels::Serve()
{
  while (const std::optional<PageFaults::Fault> fault = this->faults->Next())
  {
    const std::size_t unit = this->units.UnitAt(std::uint64_t(fault->page - this->pages));
    if (fault->isFirstWrite)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->states[unit].isWritten = this->states[unit].state != State::Missing;
      this->faults->AllowWriting(fault->page);
      continue;
    }
    const State before = this->Begin(unit);
    if (before == State::Missing)
    {
      this->Provide(unit);
    }
    if (before != State::Coming) // else the page that is put there lets those go on who wait for it
    {
      this->faults->Wake(fault->page);
    }
  }
}

ChunkedVoxels::State ChunkedVoxels::Begin(std::size_t unit)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  State& state = this->states[unit].state;
  return std::exchange(state, state == State::Missing ? State::Coming : state);
}

// The lock is not held while the unit is read and put there: others are read at the same time, and
// MappedMemory needs it to drop units, for which pages have to wait where memory is short.
void ChunkedVoxels::Provide(std::size_t unit)
{
  std::string newProblem;
  try
  {
    const std::optional<BrickSource::Box> behind = this->units.BoxBehind(unit);
    const bool isOfZeros =
      this->IsOfZeros(this->units.BoxOf(unit)) && (!behind || this->IsOfZeros(*behind));
    isOfZeros ? this->PutZeros(unit) : this->PutVoxels(unit);
  }
  catch (const std::exception& error)
  {
    this->PutZeros(unit);
    newProblem = error.what();
    newProblem.resize(newProblem.find_last_not_of('.') + 1);
    newProblem += "; voxels that are missing count as 0. Open the volume again when it is whole";
  }
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->states[unit].state = State::There;
  this->states[unit].readAt = TimeNow();
  this->problem = newProblem.empty() ? this->problem : newProblem;
}

// The ranges of floats do not tell 0 from values that are nearly 0.
bool ChunkedVoxels::IsOfZeros(const BrickSource::Box& box) const
{
  const bool isNotStored = this->source->Fill() == 0.0 && IsEmpty(this->source->Occupied(box));
  return isNotStored ||
    (this->source->Type() != VoxelType::Float32 && AreZero(this->summary->ranges, box));
}

/// Reads all but columns of chunks that are known to be zeros.
std::vector<char> ChunkedVoxels::VoxelsOf(const BrickSource::Box& box) const
{
  const auto rows = std::size_t((box.upper[1] - box.lower[1]) * (box.upper[2] - box.lower[2]));
  std::vector<char> voxels(rows * this->units.RowBytes());
  const std::int64_t width = this->source->Levels().front().chunk[0];
  const auto column = [&](std::size_t begin, std::size_t end)
  {
    BrickSource::Box part = box;
    part.lower[0] = std::int64_t(begin) * width;
    part.upper[0] = std::min(std::int64_t(end) * width, box.upper[0]);
    return part;
  };
  EachRun(
    std::size_t((box.upper[0] + width - 1) / width),
    [&](std::size_t i) { return this->IsOfZeros(column(i, i + 1)); },
    [&](std::size_t begin, std::size_t end, bool areZeros)
    {
      if (!areZeros)
      {
        this->ReadColumns(column(begin, end), voxels);
      }
    });
  return voxels;
}

void ChunkedVoxels::ReadColumns(const BrickSource::Box& columns, std::vector<char>& rows) const
{
  const auto bytes = std::size_t(columns.upper[0] - columns.lower[0]) * this->voxelBytes;
  const std::size_t rowBytes = this->units.RowBytes();
  if (bytes == rowBytes)
  {
    this->source->Read(0, columns, rows.data());
    return;
  }
  const std::size_t count = rows.size() / rowBytes;
  std::vector<char> read(count * bytes);
  this->source->Read(0, columns, read.data());
  const std::size_t first = std::size_t(columns.lower[0]) * this->voxelBytes;
  for (std::size_t row = 0; row < count; ++row)
  {
    std::memcpy(rows.data() + row * rowBytes + first, read.data() + row * bytes, bytes);
  }
}

void ChunkedVoxels::PutVoxels(std::size_t unit)
{
  const BrickSource::Box box = this->units.BoxOf(unit);
  const std::vector<char> own = this->VoxelsOf(box);
  const std::optional<BrickSource::Box> boxBehind = this->units.BoxBehind(unit);
  const std::vector<char> behind = boxBehind ? this->VoxelsOf(*boxBehind) : std::vector<char>();
  const std::size_t ownSlice = BytesOfSlice(own, box);
  const std::size_t sliceBehind = boxBehind ? BytesOfSlice(behind, *boxBehind) : 0;
  const std::vector<Pages> slices = this->PagesOf(unit);
  this->states[unit].areZeros.resize(slices.back().first + slices.back().count);
  this->states[unit].droppableBytes = 0;
  std::vector<char> bytes;
  for (std::size_t number = 0; number < slices.size(); ++number)
  {
    const Pages& pages = slices[number];
    const std::size_t skipped = std::size_t(pages.bytes - this->pages) -
      this->units.ByteOfRow(box.lower[1], box.lower[2] + std::int64_t(number));
    bytes.assign(own.begin() + std::ptrdiff_t(number * ownSlice + skipped),
      own.begin() + std::ptrdiff_t((number + 1) * ownSlice));
    const auto next =
      behind.begin() + std::ptrdiff_t(std::min(number * sliceBehind, behind.size()));
    bytes.insert(bytes.end(), next,
      next + std::ptrdiff_t(std::min(sliceBehind, std::size_t(behind.end() - next))));
    bytes.resize(pages.count * PageBytes());
    this->PutPages(pages, bytes, this->states[unit]);
  }
}

// Pages that were put there as zeros are still there.
void ChunkedVoxels::PutPages(const Pages& pages, const std::vector<char>& bytes, Unit& unit)
{
  enum class Kind
  {
    IsThere,
    Zeros,
    Voxels
  };
  const auto kindOf = [&](std::size_t page)
  {
    return unit.areZeros[pages.first + page]             ? Kind::IsThere
      : IsPageOfZeros(bytes.data() + page * PageBytes()) ? Kind::Zeros
                                                         : Kind::Voxels;
  };
  const auto put = [&](std::size_t begin, std::size_t end, Kind kind)
  {
    const std::size_t from = begin * PageBytes();
    const std::size_t count = (end - begin) * PageBytes();
    if (kind == Kind::Zeros)
    {
      this->faults->PutZeros(pages.bytes + from, count);
      std::fill_n(unit.areZeros.begin() + std::ptrdiff_t(pages.first + begin), end - begin, true);
    }
    if (kind == Kind::Voxels)
    {
      this->faults->Put(pages.bytes + from, bytes.data() + from, count);
      unit.droppableBytes += count;
    }
  };
  EachRun(pages.count, kindOf, put);
}

// Nothing of such a unit is dropped.
void ChunkedVoxels::PutZeros(std::size_t unit)
{
  this->states[unit].droppableBytes = 0;
  for (const Pages& pages : this->PagesOf(unit))
  {
    this->faults->PutZeros(pages.bytes, pages.count * PageBytes());
  }
}

}
