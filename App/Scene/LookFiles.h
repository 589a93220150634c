#ifndef Varimarch_Scene_LookFiles_h
#define Varimarch_Scene_LookFiles_h

#include "Scene/LookFormats/LookContext.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A kind of file that holds a look.
struct LookFileFormat
{
  std::string description; ///< "3D Slicer volume properties"
  std::string extension;   ///< ".vp.json", in small letters
  bool canBeWritten;
};

/// Ours is the first.
const std::vector<LookFileFormat>& LookFileFormats();

/// Reads a preset of ours or a look of another program, by the ending of its name, and JSON by what
/// is in it. Commas after the last element, as programs that write JSON by hand leave them, are no
/// error.
/// @throws std::runtime_error one sentence that names the file
Preset ReadLookFile(const std::string& path, const LookContext& context);

/// Writes a preset in units of the data as the ending of the name says, by default as ours, and
/// names it after the file. Files of other programs hold the look alone.
/// @throws std::runtime_error one sentence that names the file
void WriteLookFile(const Preset& preset, const std::string& path, const LookContext& context);

}

#endif
