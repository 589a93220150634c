#ifndef Varimarch_Scene_MricroGlClut_h
#define Varimarch_Scene_MricroGlClut_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// MRIcroGL's colour tables, *.clut: lines of KEY=VALUE with nodes from 0 to 255 between two
/// values. A table that names no two values is spread over the volume's.
/// @throws std::runtime_error one sentence; `file` names the text in it, and the look
Look LookFromClut(const std::string& text, const std::string& file, const LookContext& context);

}

#endif
