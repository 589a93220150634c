#ifndef Varimarch_Frame_UserShaderCode_h
#define Varimarch_Frame_UserShaderCode_h

#include <map>
#include <string>

class vtkVolume;

namespace varimarch
{

/// What a user has put into the shader: the text of slots, in place of the files that would be
/// chosen for them, and uniforms. A slot is a folder of VolumeModule/Shaders; what its text must
/// define stands in Slots.glsl.
struct UserShaderCode
{
  std::map<std::string, std::string> textOfSlot;
  std::string uniforms; ///< their declarations

  bool IsEmpty() const { return this->textOfSlot.empty() && this->uniforms.empty(); }
};

/// Taken from the replacements "//Varimarch::SLOT" of the volume's shader property, for fragment
/// shaders, and from its custom uniforms.
UserShaderCode UserShaderCodeOf(vtkVolume* volume);

/// What of the volume's shader property is not for our shaders: a sentence followed by a space, or
/// nothing.
std::string MissingShaderCode(vtkVolume* volume);

}

#endif
