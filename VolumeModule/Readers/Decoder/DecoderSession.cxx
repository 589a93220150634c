#include "Readers/Decoder/DecoderSession.h"

#include "Readers/Decoder/Jobs.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace varimarch
{
namespace
{

/// A descriptor above those that the process inherits. The lowest ones are free if a program has
/// closed its standard input and output.
int Raised(int descriptor)
{
  constexpr int Lowest = 16;
  const OwnedDescriptor original(descriptor);
  return descriptor < 0 ? -1 : fcntl(descriptor, F_DUPFD_CLOEXEC, Lowest);
}

/// A file in memory that nobody can make shorter, which would end this process too.
int SharedMemory()
{
  const int memory = Raised(memfd_create("varimarch-decode", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  const bool isUsable = memory >= 0 &&
    ftruncate(memory, off_t(Channel::HalfCount * Channel::HalfBytes)) == 0 &&
    fcntl(memory, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0;
  const OwnedDescriptor unusable(isUsable ? -1 : memory);
  return isUsable ? memory : -1;
}

/// The variables that the loader needs to find libraries; plug-ins of HDF5 are not loaded.
std::vector<std::string> CleanEnvironment()
{
  std::vector<std::string> variables = { "LC_ALL=C.UTF-8", "HDF5_PLUGIN_PRELOAD=::" };
  for (const char* name : { "LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS" })
  {
    if (const char* value = std::getenv(name))
    {
      variables.push_back(std::string(name) + '=' + value);
    }
  }
  return variables;
}

/// Attributes and actions of a new process, which are freed with this object.
class Spawning
{
public:
  Spawning(int socket, int memory)
  {
    posix_spawn_file_actions_init(&this->actions);
    for (const int standard : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
    {
      posix_spawn_file_actions_addopen(&this->actions, standard, "/dev/null", O_RDWR, 0);
    }
    posix_spawn_file_actions_adddup2(&this->actions, socket, DecoderSocket);
    posix_spawn_file_actions_adddup2(&this->actions, memory, DecoderMemory);
    posix_spawn_file_actions_addclosefrom_np(&this->actions, DecoderMemory + 1);

    posix_spawnattr_init(&this->attributes);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&this->attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&this->attributes, &signals);
    // In a group of its own, the process does not get the signal of Ctrl+C.
    posix_spawnattr_setpgroup(&this->attributes, 0);
    posix_spawnattr_setflags(
      &this->attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~Spawning()
  {
    posix_spawn_file_actions_destroy(&this->actions);
    posix_spawnattr_destroy(&this->attributes);
  }
  Spawning(const Spawning&) = delete;
  void operator=(const Spawning&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

}

DecoderProcess::DecoderProcess()
  : memory(SharedMemory())
{
  int sockets[2] = { -1, -1 };
  socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets);
  this->socket.Take(Raised(sockets[0]));
  const OwnedDescriptor other(Raised(sockets[1]));
  if (this->socket.Get() < 0 || other.Get() < 0 || this->memory.Get() < 0)
  {
    throw std::runtime_error(std::string("the error \"") + std::strerror(errno) + '"');
  }
  this->channel = std::make_unique<Channel>(this->socket.Get(), this->memory.Get());
  this->Start(other.Get());
}

void DecoderProcess::Start(int socketOfProcess)
{
  const std::string program = Program();
  std::vector<std::string> variables = CleanEnvironment();
  std::vector<char*> environment;
  for (std::string& variable : variables)
  {
    environment.push_back(variable.data());
  }
  environment.push_back(nullptr);
  std::string name = "varimarch-decode";
  char* const arguments[] = { name.data(), nullptr };
  const Spawning spawning(socketOfProcess, this->memory.Get());
  const int error = posix_spawn(&this->process, program.c_str(), &spawning.actions,
    &spawning.attributes, arguments, environment.data());
  if (error != 0)
  {
    this->process = -1;
    throw std::runtime_error("the error \"" + std::string(std::strerror(error)) +
      "\" when the program \"" + program + "\" was started");
  }
}

DecoderProcess::~DecoderProcess()
{
  this->Ending();
}

std::string DecoderProcess::Ending()
{
  int status = 0;
  pid_t ended = -1;
  if (this->process > 0)
  {
    // A process that has ended by itself keeps its own status.
    kill(this->process, SIGKILL);
    do
    {
      ended = waitpid(this->process, &status, 0);
    } while (ended < 0 && errno == EINTR);
  }
  this->process = -1;
  if (ended > 0 && WIFSIGNALED(status))
  {
    return std::string("the signal \"") + strsignal(WTERMSIG(status)) + '"';
  }
  return ended > 0 ? "the exit code " + std::to_string(WEXITSTATUS(status)) : "an unknown status";
}

std::string DecoderProcess::Program()
{
  if (const char* given = secure_getenv("VARIMARCH_DECODER"))
  {
    return given;
  }
  Dl_info library = {};
  dladdr(reinterpret_cast<const void*>(&DecoderProcess::Program), &library);
  std::error_code ignored;
  const std::filesystem::path file =
    std::filesystem::canonical(library.dli_fname ? library.dli_fname : "", ignored);
  return (file.parent_path() / VARIMARCH_DECODER_BESIDE_LIBRARY).string();
}

namespace
{

thread_local DecoderSession* current = nullptr;

}

DecoderSession::DecoderSession(double longestSilence)
  : outer(current)
  , longestSilence(longestSilence)
{
  current = this;
}

DecoderSession::~DecoderSession()
{
  current = this->outer;
  if (this->outer && this->idle)
  {
    this->outer->Return(std::move(this->idle));
  }
}

DecoderSession* DecoderSession::Current()
{
  return current;
}

std::unique_ptr<DecoderProcess> DecoderSession::Idle()
{
  if (!this->idle && this->outer)
  {
    return this->outer->Idle();
  }
  return this->idle ? std::move(this->idle) : std::make_unique<DecoderProcess>();
}

void DecoderSession::LosePatience()
{
  constexpr double Least = 5.0;
  this->longestSilence =
    std::max(0.5 * this->longestSilence, std::min(Least, this->longestSilence));
}

}
