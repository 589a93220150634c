#include "Scene/OutputFile.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

// The unfinished file, for a signal handler: plain bytes, no allocation. Empty when there is none.
char unfinishedPath[4096] = "";

void RemoveAndDie(int signal)
{
  if (unfinishedPath[0] != '\0')
  {
    unlink(unfinishedPath);
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
  // Two programs that write one file must not write one part.
  const std::string part = path + "." + std::to_string(getpid()) + ".part";
  SetUnfinishedPath(part);
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream.write(bytes.data(), std::streamsize(bytes.size()));
  stream.close();
  if (!stream || std::rename(part.c_str(), path.c_str()) != 0)
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

}
