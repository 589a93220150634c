#include "Frame/UserShaderCode.h"

#include "vtkOpenGLUniforms.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <vector>

namespace varimarch
{

namespace
{

const std::string Mark = "//Varimarch::";

struct Replacement
{
  std::string mark;
  std::string text;
  bool isOurs;
};

std::vector<Replacement> ReplacementsOf(vtkShaderProperty* property)
{
  std::vector<Replacement> replacements;
  for (int i = 0; i < property->GetNumberOfShaderReplacements(); ++i)
  {
    Replacement replacement;
    bool first;
    bool all;
    property->GetNthShaderReplacement(i, replacement.mark, first, replacement.text, all);
    replacement.isOurs = replacement.mark.compare(0, Mark.size(), Mark) == 0 &&
      property->GetNthShaderReplacementTypeAsString(i) == "Fragment";
    replacements.push_back(replacement);
  }
  return replacements;
}

}

UserShaderCode UserShaderCodeOf(vtkVolume* volume)
{
  UserShaderCode code;
  vtkShaderProperty* property = volume->GetShaderProperty();
  for (const Replacement& replacement : ReplacementsOf(property))
  {
    if (replacement.isOurs)
    {
      code.textOfSlot[replacement.mark.substr(Mark.size())] = replacement.text;
    }
  }
  auto* const uniforms = vtkOpenGLUniforms::SafeDownCast(property->GetFragmentCustomUniforms());
  if (uniforms)
  {
    code.uniforms = uniforms->GetDeclarations();
  }
  code.inputs =
    Fingerprint(property->GetShaderMTime(), uniforms ? uniforms->GetUniformListMTime() : 0);
  return code;
}

std::string MissingShaderCode(vtkVolume* volume)
{
  vtkShaderProperty* property = volume->GetShaderProperty();
  if (property->HasVertexShaderCode() || property->HasFragmentShaderCode() ||
    property->HasGeometryShaderCode())
  {
    return "Whole shaders cannot be replaced: replace slots, as //Varimarch::SLOT. ";
  }
  for (const Replacement& replacement : ReplacementsOf(property))
  {
    if (!replacement.isOurs)
    {
      return "The shader has no " + replacement.mark +
        " to replace: replace slots, as //Varimarch::SLOT. ";
    }
  }
  return "";
}

}
