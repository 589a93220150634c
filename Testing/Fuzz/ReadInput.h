#ifndef Varimarch_Testing_Fuzz_ReadInput_h
#define Varimarch_Testing_Fuzz_ReadInput_h

#include "Scene/Model/Scene.h"

#include <string>

namespace varimarch
{

/// Reads a volume, and requires the reader's promises: an image in space without an error, or one
/// error in one sentence without an image. This is the only place that chooses where files are
/// decoded. Returns true if the volume was read.
/// @param raw  layout of raw voxels; null for files with a header
bool ReadInput(const std::string& path, const RawLayout* raw = nullptr);

}

#endif
