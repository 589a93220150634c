#ifndef Varimarch_Scene_SlicerScene_h
#define Varimarch_Scene_SlicerScene_h

#include "Scene/LookFormats/LookContext.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Reads the volume properties in a MRML scene of 3D Slicer, such as its presets.xml. Their names
/// become those of the looks.
/// @param file  text that names the file in errors
/// @throws std::runtime_error with one sentence
std::vector<Look> LooksFromSlicerScene(
  const std::string& text, const std::string& file, const LookContext& context);

}

#endif
