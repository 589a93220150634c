#ifndef Varimarch_Scene_LookFiles_h
#define Varimarch_Scene_LookFiles_h

#include "Scene/Looks/LookFormats/LookContext.h"

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

/// The extensions of formats that can be written.
std::vector<std::string> WritableLookExtensions();

/// Reads our presets or another program's looks. The extension decides on the format, for JSON also
/// the content. Trailing commas, as hand-written JSON has them, are accepted.
/// @return at least one preset; most formats hold only one
/// @throws std::runtime_error one sentence that names the file
std::vector<Preset> ReadLookFile(const std::string& path, const LookContext& context);

/// Reads the look of a name. An empty name stands for the only look of a file.
/// @throws std::runtime_error one sentence that names the file and lists its looks if the name does
///         not select one
Preset ReadLook(const std::string& path, const std::string& name, const LookContext& context);

/// Writes a preset, whose values are in units of the data, in the format of the file name's
/// extension, ours by default. The preset is named after the file. Other programs' formats hold
/// only the look.
/// @throws std::runtime_error one sentence that names the file
void WriteLookFile(const Preset& preset, const std::string& path, const LookContext& context);

}

#endif
