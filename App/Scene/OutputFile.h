#ifndef Varimarch_Scene_OutputFile_h
#define Varimarch_Scene_OutputFile_h

#include <functional>
#include <string>

namespace varimarch
{

/// A file under construction. It is written under a temporary name, with the process id and "part"
/// before the extension, so that nobody sees it incomplete. Unless it is completed, the destructor
/// deletes it.
class UnfinishedFile
{
public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  void operator=(const UnfinishedFile&) = delete;

  /// The temporary name to write to.
  const std::string& Part() const { return this->part; }

  /// Renames the file to its final name and replaces a file of that name.
  /// @throws std::runtime_error that names the file and the system's reason
  void Complete();

private:
  std::string path;
  std::string part;
};

/// Writes a file under a temporary name and renames it when complete.
/// @throws std::runtime_error that names the file and the system's reason
void WriteFileWhole(const std::string& path, const std::string& bytes);

/// The same for writers that take a file name.
/// @param write  writes to the given name and returns true on success
void WriteFileWhole(
  const std::string& path, const std::function<bool(const std::string& part)>& write);

/// From now on SIGINT and SIGTERM delete the unfinished file that was begun last.
void RemoveUnfinishedFileOnInterrupt();

/// Sets the line that these signals print to stderr before they end the program. It is given
/// without a line break and cut to 1023 bytes. Empty, the default, prints nothing.
void SetInterruptNotice(const std::string& notice);

}

#endif
