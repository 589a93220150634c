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

// For the error that the system met last.
[[noreturn]] void FailToWrite(const std::string& path)
{
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

// Two programs that write one file must not write one part.
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
