#ifndef Varimarch_CommandLine_OutputFolder_h
#define Varimarch_CommandLine_OutputFolder_h

#include <filesystem>
#include <string>

namespace varimarch
{

/// A folder to write into, created if it does not exist.
/// @throws std::runtime_error that names the folder and the system's reason
std::filesystem::path OutputFolder(const std::string& path);

/// Sets the message that Ctrl-C and SIGTERM print from now on.
/// @param contents  the contents of the folder so far
void SetInterruptNotice(const std::filesystem::path& folder, const std::string& contents);

}

#endif
