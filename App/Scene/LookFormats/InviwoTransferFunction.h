#ifndef Varimarch_Scene_InviwoTransferFunction_h
#define Varimarch_Scene_InviwoTransferFunction_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// Reads Inviwo's transfer functions, *.itf: XML of any version. Nodes lie between 0 and 1 over the
/// range of the volume's values, or at values; only those between the two ends of the mask are
/// visible.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromItf(const std::string& text, const std::string& file, const LookContext& context);

}

#endif
