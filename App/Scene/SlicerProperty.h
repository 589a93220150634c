#ifndef Varimarch_Scene_SlicerProperty_h
#define Varimarch_Scene_SlicerProperty_h

#include "Scene/Scene.h"

#include <string>

namespace varimarch
{

/// 3D Slicer's volume property files, *.vp: nine lines of numbers. They know neither midpoints,
/// sharpness, blending nor a unit distance; a look has no gradient opacity, so theirs is left out.

/// Nodes are put in order, and brought into their ranges: files in use need it.
/// @param file  names the text in errors, and the look
/// @throws std::runtime_error that says in one sentence what is wrong with it
Look LookFromSlicerText(const std::string& text, const std::string& file);

/// @param look  in units of the data
std::string SlicerText(const Look& look);

}

#endif
