#ifndef Varimarch_CommandLine_OutputFolder_h
#define Varimarch_CommandLine_OutputFolder_h

#include <filesystem>
#include <string>

namespace varimarch
{

/// A folder to write into, made when it is not there.
/// @throws std::runtime_error that names it and the system's reason
std::filesystem::path OutputFolder(const std::string& path);

}

#endif
