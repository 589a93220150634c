#ifndef Varimarch_Scene_OutputFile_h
#define Varimarch_Scene_OutputFile_h

#include <functional>
#include <string>

namespace varimarch
{

/// A file that nobody ever sees half of: while it is written its name has the process and "part"
/// before the extension, and it goes unless it is completed.
class UnfinishedFile
{
public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  void operator=(const UnfinishedFile&) = delete;

  /// To write to.
  const std::string& Part() const { return this->part; }

  /// Gives it its name, in place of a file that had it.
  /// @throws std::runtime_error that names the file and the system's reason
  void Complete();

private:
  std::string path;
  std::string part;
};

/// Writes a file at once that nobody ever sees half of.
/// @throws std::runtime_error that names the file and the system's reason
void WriteFileWhole(const std::string& path, const std::string& bytes);

/// The same by what can only write to a file of a name.
/// @param write  writes the file of the name that it is given, and returns whether that is done
void WriteFileWhole(
  const std::string& path, const std::function<bool(const std::string& part)>& write);

/// From now on Ctrl-C and a request to terminate take the last unfinished file away with them.
void RemoveUnfinishedFileOnInterrupt();

/// What they say on stderr before they end the program: a line without its end, of less than 1024
/// bytes, cut otherwise. Empty, as at the beginning: nothing.
void SetInterruptNotice(const std::string& notice);

}

#endif
