#ifndef Varimarch_Scene_OsirixPreset_h
#define Varimarch_Scene_OsirixPreset_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// 3D presets and 16-bit colour tables of OsiriX, Horos and InVesalius, *.plist, in XML or binary:
/// curves of opacity with a colour at each point, transparent beside them. Where two overlap, that
/// of the larger opacity is seen. Tables of 256 colours alone are spread over the opacities that
/// stay.
/// @throws std::runtime_error one sentence; `file` names the bytes in it, and the look
Look LookFromPlist(const std::string& bytes, const std::string& file, const LookContext& context);

}

#endif
