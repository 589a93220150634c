#ifndef Varimarch_Scene_InviwoTransferFunction_h
#define Varimarch_Scene_InviwoTransferFunction_h

#include "Scene/LookFormats/LookContext.h"

#include <string>

namespace varimarch
{

/// Inviwo's transfer functions, *.itf, in XML of all versions: points from 0 to 1 over the volume's
/// values, or at values, visible between the two ends of a mask.
/// @throws std::runtime_error one sentence; `file` names the text in it, and the look
Look LookFromItf(const std::string& text, const std::string& file, const LookContext& context);

}

#endif
