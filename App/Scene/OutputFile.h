#ifndef Varimarch_Scene_OutputFile_h
#define Varimarch_Scene_OutputFile_h

#include <string>

namespace varimarch
{

/// Writes a file so that nobody ever sees half of it: under the name with the process and ".part"
/// added, renamed when complete. Replaces a file of that name.
/// @throws std::runtime_error that names the file and the system's reason
void WriteFileWhole(const std::string& path, const std::string& bytes);

/// From now on Ctrl-C and a request to terminate take an unfinished ".part" file away with them.
void RemoveUnfinishedFileOnInterrupt();

}

#endif
