#ifndef Varimarch_Scene_PartFiles_h
#define Varimarch_Scene_PartFiles_h

#include <filesystem>
#include <string>

namespace varimarch
{

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
