#include "Scene/Files/OutputFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace varimarch
{

namespace
{

namespace fs = std::filesystem;

// Path of the unfinished file in plain memory, since a signal handler must not allocate. Empty if
// there is none.
char unfinishedPath[4096] = "";

// The line that is printed at an interrupt, which may come while static objects are destroyed.
char interruptNotice[1024] = "";

// Held to change the two above, and by the thread that waits for interrupts.
std::mutex interruptMutex;

// The sentence about a fault, complete but for the number of its signal.
char faultNotice[256] = "";

void Print(const char* text)
{
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0)
  {
    // Nothing can be reported if stderr is closed.
  }
}

void DeleteUnfinishedFile()
{
  if (unfinishedPath[0] != '\0')
  {
    unlink(unfinishedPath);
  }
}

// The folder that is being filled; empty if there is none.
std::string unfinishedFolder;

// Waits for one of the signals, which all threads block.
[[noreturn]] void AwaitInterrupt(sigset_t interrupts)
{
  int signal = 0;
  sigwait(&interrupts, &signal);
  constexpr unsigned MostSeconds = 5; // the folder of the file may be gone too
  alarm(MostSeconds);
  const std::lock_guard<std::mutex> lock(interruptMutex);
  DeleteUnfinishedFile();
  std::error_code ignored;
  constexpr int MostTries = 100; // other threads may add files meanwhile
  for (int tries = 0; tries < MostTries && fs::exists(unfinishedFolder, ignored); ++tries)
  {
    fs::remove_all(unfinishedFolder, ignored);
  }
  Print(interruptNotice);
  // With the default action, the parent process sees the signal that ended the program.
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &interrupts, nullptr);
  std::raise(signal);
  _exit(EXIT_FAILURE);
}

// The threads of the program leave interrupts to a thread of their own. A handler would not be
// called while a file is read from a network disk that is gone; the default action ends even that.
void DeleteUnfinishedFileOnInterrupts()
{
  sigset_t interrupts;
  sigemptyset(&interrupts);
  sigaddset(&interrupts, SIGINT);
  sigaddset(&interrupts, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &interrupts, nullptr);
  std::thread(AwaitInterrupt, interrupts).detach();
}

void DeleteAndFail(int signal)
{
  DeleteUnfinishedFile();
  Print(faultNotice);
  const char digits[] = { char('0' + signal / 10), char('0' + signal % 10), ')', '.', '\n', '\0' };
  Print(digits);
  _exit(EXIT_FAILURE);
}

void SetUnfinishedPath(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(interruptMutex);
  unfinishedPath[0] = '\0';
  if (path.size() < sizeof(unfinishedPath))
  {
    std::memcpy(unfinishedPath, path.c_str(), path.size() + 1);
  }
}

// Renaming would replace a device, such as /dev/null, by a file, and also a file that is protected.
void CheckMayBeWritten(const std::string& path)
{
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw std::runtime_error(path + ": expected the name of a file to write, found " +
      (fs::is_directory(status) ? "a folder" : "a device or a pipe"));
  }
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0)
  {
    FailToWrite(path);
  }
}

// Returns the descriptor of a new file that is locked where the file system has locks; -1 if
// another process deleted it before it was locked. A negative descriptor with errno set to another
// value than EAGAIN is a failure.
int NewLockedFile(const std::string& part)
{
  const int file = open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0)
  {
    return -1;
  }
  const bool isTaken = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  struct stat status = {};
  if (!isTaken && fstat(file, &status) == 0 && status.st_nlink > 0)
  {
    return file;
  }
  close(file);
  errno = EAGAIN;
  return -1;
}

// Waits until a file or folder is on the disk. Some file systems cannot tell.
bool IsOnDisk(int descriptor)
{
  return fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP;
}

// A folder under construction; see UnfinishedFile.
class UnfinishedFolder
{
public:
  explicit UnfinishedFolder(const std::string& path)
    : path(path)
    , part(NewPartOf(path))
  {
    DeleteLeftFiles(FolderOf(path));
    if (mkdir(this->part.c_str(), 0777) != 0)
    {
      FailToWrite(path);
    }
    this->lock = open(this->part.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    flock(this->lock, LOCK_EX | LOCK_NB);
    SetUnfinishedFolder(this->part);
  }
  ~UnfinishedFolder()
  {
    SetUnfinishedFolder("");
    std::error_code ignored;
    fs::remove_all(this->part, ignored);
    close(this->lock);
  }
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  void operator=(const UnfinishedFolder&) = delete;

  const std::string& Part() const { return this->part; }

  // Waits until the bytes are on the disk. What was there before is deleted last.
  void Complete(const std::function<bool(const std::string& existing)>& mayReplace)
  {
    syncfs(this->lock);
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(this->path, unknown)))
    {
      this->Rename(this->part, this->path);
    }
    else if (mayReplace(this->path))
    {
      this->Replace();
    }
    else
    {
      throw std::runtime_error(this->path + ": exists already, and is not replaced");
    }
    SyncFolder(FolderOf(this->path));
  }

private:
  // Both change their names at once, so that a program that is killed leaves one of them whole
  // under the final name. The part, which is deleted, is then what was there before.
  void Replace()
  {
    if (renameat2(AT_FDCWD, this->part.c_str(), AT_FDCWD, this->path.c_str(), RENAME_EXCHANGE) == 0)
    {
      return;
    }
    if (errno != EINVAL && errno != ENOSYS)
    {
      FailToWrite(this->path);
    }
    // File systems such as NFS change one name at a time.
    const std::string old = NewPartOf(this->path);
    this->Rename(this->path, old);
    if (std::rename(this->part.c_str(), this->path.c_str()) != 0)
    {
      const int reason = errno;
      std::rename(old.c_str(), this->path.c_str());
      errno = reason;
      FailToWrite(this->path);
    }
    std::error_code ignored;
    fs::remove_all(old, ignored);
  }

  void Rename(const std::string& from, const std::string& to) const
  {
    if (std::rename(from.c_str(), to.c_str()) != 0)
    {
      FailToWrite(this->path);
    }
  }

  static void SetUnfinishedFolder(const std::string& folder)
  {
    const std::lock_guard<std::mutex> lock(interruptMutex);
    unfinishedFolder = folder;
  }

  std::string path;
  std::string part;
  int lock = -1; // descriptor of the part, locked as long as this process lives
};

}

UnfinishedFile::UnfinishedFile(const std::string& path)
  : path(path)
{
  CheckMayBeWritten(path);
  DeleteLeftFiles(FolderOf(path));
  do
  {
    this->part = NewPartOf(path);
    this->lock = NewLockedFile(this->part);
  } while (this->lock < 0 && (errno == EAGAIN || errno == EEXIST));
  if (this->lock < 0)
  {
    FailToWrite(path);
  }
  SetUnfinishedPath(this->part);
}

UnfinishedFile::~UnfinishedFile()
{
  std::remove(this->part.c_str());
  close(this->lock);
  SetUnfinishedPath("");
}

void UnfinishedFile::Complete()
{
  struct stat old = {};
  if (lstat(this->path.c_str(), &old) == 0 && S_ISREG(old.st_mode))
  {
    // A private file stays private.
    fchmod(this->lock, old.st_mode & 0777);
  }
  if (!IsOnDisk(this->lock) || std::rename(this->part.c_str(), this->path.c_str()) != 0)
  {
    FailToWrite(this->path);
  }
  SyncFolder(FolderOf(this->path));
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

void WriteFolderWhole(const std::string& path,
  const std::function<bool(const std::string& existing)>& mayReplace,
  const std::function<void(const std::string& part)>& fill)
{
  // A slash at the end would make the folder its own parent.
  fs::path final = path;
  final = final.has_filename() ? final : final.parent_path();
  UnfinishedFolder folder(final.string());
  fill(folder.Part());
  folder.Complete(mayReplace);
}

void DeleteUnfinishedFileOnSignals(const std::string& program)
{
  DeleteUnfinishedFileOnInterrupts();
  std::snprintf(faultNotice, sizeof(faultNotice),
    "%.60s: a library or the graphics driver failed, perhaps for lack of memory; no unfinished "
    "file is left. Close other programs or use a smaller volume (signal ",
    program.c_str());
  // A stack of its own, for faults by which the program's is used up.
  static std::array<char, 1 << 16> stack;
  const stack_t alternative = { stack.data(), 0, stack.size() };
  sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = DeleteAndFail;
  action.sa_flags = int(SA_ONSTACK | SA_RESETHAND);
  for (const int fault : { SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL })
  {
    // Sanitizers have handlers already.
    struct sigaction before = {};
    if (sigaction(fault, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
    {
      sigaction(fault, &action, nullptr);
    }
  }
}

void SetInterruptNotice(const std::string& notice)
{
  const std::lock_guard<std::mutex> lock(interruptMutex);
  const std::string line =
    notice.empty() ? "" : notice.substr(0, sizeof(interruptNotice) - 2) + "\n";
  std::memcpy(interruptNotice, line.c_str(), line.size() + 1);
}

namespace
{

namespace fs = std::filesystem;

const std::string partPrefix = "varimarch-";
const std::string partMark = ".part";

// Deletes a file of this user unless a process holds its lock.
void DeleteUnlessLocked(const fs::path& path)
{
  const int file = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status = {};
  if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
    status.st_uid == geteuid() && flock(file, LOCK_EX | LOCK_NB) == 0)
  {
    unlink(path.c_str());
  }
  if (file >= 0)
  {
    close(file);
  }
}

// The same for a folder, whose lock is that of the folder itself.
void DeleteFolderUnlessLocked(const fs::path& path)
{
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat status = {};
  if (folder >= 0 && fstat(folder, &status) == 0 && status.st_uid == geteuid() &&
    flock(folder, LOCK_EX | LOCK_NB) == 0)
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  if (folder >= 0)
  {
    close(folder);
  }
}

}

void FailToWrite(const std::string& path)
{
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

fs::path FolderOf(const std::string& path)
{
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string NewPartOf(const std::string& path)
{
  static std::atomic<unsigned> count = 0;
  const std::string name =
    partPrefix + std::to_string(getpid()) + '-' + std::to_string(++count) + partMark;
  return (FolderOf(path) / name).string() + fs::path(path).extension().string();
}

void DeleteLeftFiles(const fs::path& folder)
{
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name.compare(0, partPrefix.size(), partPrefix) == 0 &&
      name.find(partMark) != std::string::npos)
    {
      DeleteUnlessLocked(entry->path());
      DeleteFolderUnlessLocked(entry->path());
    }
  }
}

void SyncFolder(const fs::path& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0)
  {
    fsync(descriptor);
    close(descriptor);
  }
}

}
