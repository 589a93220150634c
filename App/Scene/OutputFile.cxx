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

// The unfinished file, for a signal handler: plain bytes, no allocation. Empty when there is none.
char unfinishedPath[4096] = "";

// What it says, likewise: the other one is written while this one may be read.
char notices[2][1024] = { "", "" };
std::atomic<int> noticeInUse = 0;

void RemoveAndDie(int signal)
{
  if (unfinishedPath[0] != '\0')
  {
    unlink(unfinishedPath);
  }
  const char* const notice = notices[noticeInUse];
  if (notice[0] != '\0' && write(STDERR_FILENO, notice, std::strlen(notice)) < 0)
  {
    // There is nobody left to be told.
  }
  // The default action again, so that the caller sees which signal ended the program.
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
  // Two programs that write one file must not write one part.
  const std::filesystem::path whole = path;
  std::filesystem::path unfinished = whole;
  unfinished.replace_filename(
    whole.stem().string() + "." + std::to_string(getpid()) + ".part" + whole.extension().string());
  const std::string part = unfinished.string();
  SetUnfinishedPath(part);
  errno = 0;
  if (!write(part) || std::rename(part.c_str(), path.c_str()) != 0)
  {
    const std::string reason = std::strerror(errno);
    std::remove(part.c_str());
    SetUnfinishedPath("");
    throw std::runtime_error(path + ": cannot be written: " + reason);
  }
  SetUnfinishedPath("");
}

void RemoveUnfinishedFileOnInterrupt()
{
  std::signal(SIGINT, RemoveAndDie);
  std::signal(SIGTERM, RemoveAndDie);
}

void SetInterruptNotice(const std::string& notice)
{
  const int other = 1 - noticeInUse;
  const std::string line = notice.empty() ? "" : notice.substr(0, sizeof(notices[0]) - 2) + "\n";
  std::memcpy(notices[other], line.c_str(), line.size() + 1);
  noticeInUse = other;
}

}
