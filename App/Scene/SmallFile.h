#ifndef Varimarch_Scene_SmallFile_h
#define Varimarch_Scene_SmallFile_h

#include <string>

namespace varimarch
{

/// The bytes of a scene or a look, which strangers may have made. Neither a pipe, which would make
/// the program wait, nor a file that is larger than any such file is read.
/// @throws std::runtime_error that names the file, what was expected and what was found
std::string BytesOfSmallFile(const std::string& path);

}

#endif
