#ifndef Varimarch_Scene_OutputFile_h
#define Varimarch_Scene_OutputFile_h

#include <filesystem>
#include <functional>
#include <string>

namespace varimarch
{

/// A file under construction. It is written under a temporary name beside the final one, such as
/// "varimarch-1234-1.part.png" in process 1234, so that nobody sees it incomplete. Unless it is
/// completed, the destructor deletes it. What a killed program has left is deleted when the next
/// file is written to the same folder: the system releases the lock of a process that has ended.
class UnfinishedFile
{
public:
  /// Makes an empty file for writers to open again.
  /// @throws std::runtime_error that names the file and the reason: the folder cannot be written
  /// to, or the final name belongs to a folder or a device
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  void operator=(const UnfinishedFile&) = delete;

  /// The temporary name to write to. Writers must not replace the file by another one.
  const std::string& Part() const { return this->part; }

  /// Waits until the bytes are on the disk, and renames the file to its final name. A file or a
  /// symbolic link of that name is replaced; a file's permissions are kept.
  /// @throws std::runtime_error that names the file and the system's reason
  void Complete();

private:
  std::string path;
  std::string part;
  int lock; ///< descriptor of the part, locked as long as this process lives
};

/// Writes a file under a temporary name and renames it when complete.
/// @throws std::runtime_error that names the file and the system's reason
void WriteFileWhole(const std::string& path, const std::string& bytes);

/// The same for writers that take a file name.
/// @param write  writes to the given name and returns true on success
void WriteFileWhole(
  const std::string& path, const std::function<bool(const std::string& part)>& write);

/// Fills a new folder under a temporary name beside the final one, and renames it when it is
/// complete. Otherwise it is deleted, as an UnfinishedFile is.
/// @param mayReplace  tells whether an existing folder or file of the final name may be replaced
/// @param fill  fills the folder with the given name
/// @throws std::runtime_error that names the folder and the system's reason
void WriteFolderWhole(const std::string& path,
  const std::function<bool(const std::string& existing)>& mayReplace,
  const std::function<void(const std::string& part)>& fill);

/// From now on the unfinished file that was begun last is deleted if SIGINT or SIGTERM ends the
/// program, or a fault does, such as a driver's when there is no memory left. A fault prints a
/// sentence to stderr and ends the program with exit code 1. Call it before any thread is started:
/// it blocks the two signals, which a thread of its own waits for.
/// @param program  its name, for the sentence
void DeleteUnfinishedFileOnSignals(const std::string& program);

/// Sets the line that SIGINT and SIGTERM print to stderr before they end the program. It is given
/// without a line break and cut to 1023 bytes. Empty, the default, prints nothing.
void SetInterruptNotice(const std::string& notice);

// The names of files and folders under construction, and what is left of them; see OutputFile.h.

/// A temporary name beside a final one. The process id tells users whose file it is; a number keeps
/// apart the files of a process.
std::string NewPartOf(const std::string& path);

/// Deletes the unfinished files and folders of processes that have ended.
void DeleteLeftFiles(const std::filesystem::path& folder);

/// The folder that a path is in.
std::filesystem::path FolderOf(const std::string& path);

/// Makes a renaming last. The file is complete under either name, so a failure changes nothing.
void SyncFolder(const std::filesystem::path& folder);

/// Throws the last error of the system.
/// @throws std::runtime_error that names the path, always
[[noreturn]] void FailToWrite(const std::string& path);

}

#endif
