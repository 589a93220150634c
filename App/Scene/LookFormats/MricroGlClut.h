#ifndef Varimarch_Scene_MricroGlClut_h
#define Varimarch_Scene_MricroGlClut_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// Reads MRIcroGL's colour tables, *.clut: lines of KEY=VALUE with nodes from 0 to 255 between two
/// values. A table without the two values is spread over the range of the volume's.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromClut(const std::string& text, const std::string& file, const LookContext& context);

}

#endif
