#ifndef Varimarch_Scene_RawGuess_h
#define Varimarch_Scene_RawGuess_h

#include "Scene/Scene.h"

#include <cstdint>
#include <string>

namespace varimarch
{

/// Whether a file says nothing about its voxels, by its name: "head.raw", "head.RAW.gz".
bool IsBareVoxels(const std::string& path);

/// What a raw file probably holds: by its name, as in "head_256x256x108_int16.raw", else by its
/// size, as a cube or as square slices of a usual side. Somebody has to look at it.
RawLayout GuessedRawLayout(const std::string& path, std::int64_t fileBytes);

/// As many bytes as the file needs, header and all.
std::int64_t BytesOf(const RawLayout& layout);

}

#endif
