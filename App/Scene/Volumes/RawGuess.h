#ifndef Varimarch_Scene_RawGuess_h
#define Varimarch_Scene_RawGuess_h

#include "Scene/Model/Scene.h"

#include <cstdint>
#include <string>

namespace varimarch
{

/// True if the name is that of a raw file, which does not describe its voxels: "head.raw",
/// "head.RAW.gz"; false if the file exists and has another format all the same.
bool IsBareVoxels(const std::string& path);

/// Guesses the layout of a raw file from its name, as in "head_256x256x108_int16.raw", or else from
/// its size, as a cube or as square slices of a common side. A person has to confirm the guess.
RawLayout GuessedRawLayout(const std::string& path, std::int64_t fileBytes);

/// Size of a file with this layout, header included [bytes].
std::int64_t BytesOf(const RawLayout& layout);

}

#endif
