#include "Scene/OutputFile.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Path of the unfinished file in plain memory, since a signal handler must not allocate. Empty if
// there is none.
char unfinishedPath[4096] = "";

// Double-buffered notice: one buffer is written while the signal handler may read the other.
char notices[2][1024] = { "", "" };
std::atomic<int> noticeInUse = 0;

void DeleteAndTerminate(int signal)
{
  if (unfinishedPath[0] != '\0')
  {
    unlink(unfinishedPath);
  }
  const char* const notice = notices[noticeInUse];
  if (notice[0] != '\0' && write(STDERR_FILENO, notice, std::strlen(notice)) < 0)
  {
    // Nothing can be reported if stderr is closed.
  }
  // Restore the default action, so that the parent process sees the signal that ended the program.
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void SetUnfinishedPath(const std::string& path)
{
  unfinishedPath[0] = '\0';
  if (path.size() < sizeof(unfinishedPath))
  {
    std::memcpy(unfinishedPath, path.c_str(), path.size() + 1);
  }
}

// Reports the last error of the system.
[[noreturn]] void FailToWrite(const std::string& path)
{
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

// The process id keeps two programs that write the same file from sharing a temporary file.
std::string PartOf(const std::filesystem::path& path)
{
  std::filesystem::path part = path;
  part.replace_filename(
    path.stem().string() + "." + std::to_string(getpid()) + ".part" + path.extension().string());
  return part.string();
}

}

UnfinishedFile::UnfinishedFile(const std::string& path)
  : path(path)
  , part(PartOf(path))
{
  SetUnfinishedPath(this->part);
}

UnfinishedFile::~UnfinishedFile()
{
  std::remove(this->part.c_str());
  SetUnfinishedPath("");
}

void UnfinishedFile::Complete()
{
  if (std::rename(this->part.c_str(), this->path.c_str()) != 0)
  {
    FailToWrite(this->path);
  }
}

void WriteFileWhole(const std::string& path, const std::string& bytes)
{
  WriteFileWhole(path,
    [&](const std::string& part)
    {
      std::ofstream stream(part, std::ios::binary);
      stream.write(bytes.data(), std::streamsize(bytes.size()));
      stream.close();
      return bool(stream);
    });
}

void WriteFileWhole(
  const std::string& path, const std::function<bool(const std::string& part)>& write)
{
  UnfinishedFile file(path);
  errno = 0;
  if (!write(file.Part()))
  {
    FailToWrite(path);
  }
  file.Complete();
}

void RemoveUnfinishedFileOnInterrupt()
{
  std::signal(SIGINT, DeleteAndTerminate);
  std::signal(SIGTERM, DeleteAndTerminate);
}

void SetInterruptNotice(const std::string& notice)
{
  const int other = 1 - noticeInUse;
  const std::string line = notice.empty() ? "" : notice.substr(0, sizeof(notices[0]) - 2) + "\n";
  std::memcpy(notices[other], line.c_str(), line.size() + 1);
  noticeInUse = other;
}

}
