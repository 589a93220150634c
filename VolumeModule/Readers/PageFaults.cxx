#include "Readers/PageFaults.h"

#include "Readers/PageMap.h"

#include <fcntl.h>
#include <linux/userfaultfd.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace varimarch
{
namespace
{

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

}
