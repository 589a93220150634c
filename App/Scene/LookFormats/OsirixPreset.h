#ifndef Varimarch_Scene_OsirixPreset_h
#define Varimarch_Scene_OsirixPreset_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// Reads 3D presets and 16-bit colour tables of OsiriX, Horos and InVesalius, *.plist, XML or
/// binary: opacity curves with a colour at each point, transparent outside them. Where two curves
/// overlap, the one with the larger opacity is used. Tables of 256 colours without opacities are
/// spread over the context's opacities.
/// @param file  name of the look, and of the bytes in errors
/// @throws std::runtime_error with one sentence
Look LookFromPlist(const std::string& bytes, const std::string& file, const LookContext& context);

}

#endif
