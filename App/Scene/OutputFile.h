#ifndef Varimarch_Scene_OutputFile_h
#define Varimarch_Scene_OutputFile_h

#include <functional>
#include <string>

namespace varimarch
{

/// Writes a file so that nobody ever sees half of it: under a name with the process and "part"
/// before the extension, renamed when complete. Replaces a file of that name.
/// @throws std::runtime_error that names the file and the system's reason
void WriteFileWhole(const std::string& path, const std::string& bytes);

/// The same by what can only write to a file of a name.
/// @param write  writes the file of the name that it is given, and returns whether that is done
void WriteFileWhole(
  const std::string& path, const std::function<bool(const std::string& part)>& write);

/// From now on Ctrl-C and a request to terminate take an unfinished file away with them.
void RemoveUnfinishedFileOnInterrupt();

/// What they say on stderr before they end the program: a line without its end, of less than 1024
/// bytes, cut otherwise. Empty, as at the beginning: nothing.
void SetInterruptNotice(const std::string& notice);

}

#endif
