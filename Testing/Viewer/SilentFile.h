#ifndef Varimarch_Testing_SilentFile_h
#define Varimarch_Testing_SilentFile_h

#include <csignal>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace varimarch
{

/// A file on a disk that does not answer as long as this object lives: whoever opens it waits for
/// the lease, at most for /proc/sys/fs/lease-break-time.
class SilentFile
{
public:
  explicit SilentFile(const std::string& path)
    : file(open(path.c_str(), O_RDWR | O_CLOEXEC))
  {
    // The system asks for the lease by this signal.
    std::signal(SIGIO, SIG_IGN);
    this->isSilent = fcntl(this->file, F_SETLEASE, F_WRLCK) == 0;
  }
  ~SilentFile() { close(this->file); }
  SilentFile(const SilentFile&) = delete;
  void operator=(const SilentFile&) = delete;

  /// False on file systems without leases.
  bool IsSilent() const { return this->isSilent; }

private:
  int file;
  bool isSilent = false;
};

}

#endif
