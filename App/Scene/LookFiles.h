#ifndef Varimarch_Scene_LookFiles_h
#define Varimarch_Scene_LookFiles_h

#include "Scene/LookFormats/LookContext.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A file format that holds a look.
struct LookFileFormat
{
  std::string description; ///< "3D Slicer volume properties"
  std::string extension;   ///< ".vp.json", in lower case
  bool canBeWritten;
};

/// All formats; ours comes first.
const std::vector<LookFileFormat>& LookFileFormats();

/// Reads one of our presets or another program's look. The extension decides on the format, for
/// JSON also the content. Trailing commas, as hand-written JSON has them, are accepted.
/// @throws std::runtime_error one sentence that names the file
Preset ReadLookFile(const std::string& path, const LookContext& context);

/// Writes a preset, whose values are in units of the data, in the format of the file name's
/// extension, ours by default. The preset is named after the file. Other programs' formats hold
/// only the look.
/// @throws std::runtime_error one sentence that names the file
void WriteLookFile(const Preset& preset, const std::string& path, const LookContext& context);

}

#endif
