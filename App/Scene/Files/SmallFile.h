#ifndef Varimarch_Scene_SmallFile_h
#define Varimarch_Scene_SmallFile_h

#include <cstdint>
#include <string>

namespace varimarch
{

/// The largest scene or look that is read: larger than the files that programs write.
constexpr std::uintmax_t MostBytesOfSmallFile = 16 << 20;

/// The bytes of a scene or a look, which strangers may have made. Neither a pipe, which would make
/// the program wait, nor a file that is larger than any such file is read.
/// @throws std::runtime_error that names the file, what was expected and what was found
std::string BytesOfSmallFile(const std::string& path);

}

#endif
