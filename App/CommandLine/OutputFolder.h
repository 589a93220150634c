#ifndef Varimarch_CommandLine_OutputFolder_h
#define Varimarch_CommandLine_OutputFolder_h

#include <filesystem>
#include <string>

namespace varimarch
{

/// A folder to write into, made when it is not there.
/// @throws std::runtime_error that names it and the system's reason
std::filesystem::path OutputFolder(const std::string& path);

/// What Ctrl-C and a request to terminate say from now on: that the folder holds so much.
void SetInterruptNotice(const std::filesystem::path& folder, const std::string& contents);

}

#endif
