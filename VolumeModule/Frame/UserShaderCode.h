#ifndef Varimarch_Frame_UserShaderCode_h
#define Varimarch_Frame_UserShaderCode_h

#include "Frame/Fingerprint.h"

#include <map>
#include <string>

class vtkVolume;

namespace varimarch
{

/// The user's own shader code: the text of slots, which replaces the files that would be chosen for
/// them, and uniforms. A slot is a folder of VolumeModule/Shaders; Slots.glsl declares the
/// functions that its text must define.
struct UserShaderCode
{
  std::map<std::string, std::string> textOfSlot;
  std::string uniforms; ///< The declarations of the uniforms.
  Fingerprint inputs;   ///< The times of the last changes of the code and of the uniforms.

  bool IsEmpty() const { return this->textOfSlot.empty() && this->uniforms.empty(); }
};

/// Takes the code from the replacements "//Varimarch::SLOT" of the volume's shader property, for
/// fragment shaders, and from its custom uniforms.
UserShaderCode UserShaderCodeOf(vtkVolume* volume);

/// A sentence about code of the volume's shader property that our shaders cannot use, followed by a
/// space; empty if there is none.
std::string MissingShaderCode(vtkVolume* volume);

}

#endif
