#ifndef Varimarch_Scene_SceneFormat_h
#define Varimarch_Scene_SceneFormat_h

#include "Scene/Json/JsonForm.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Everything that is made from the lists of fields in SceneFields.h but is not reading or writing:
/// Data/Scenes/scene.schema.json, the tables of Documentation/SceneFormat.md, and the settings that
/// the command line and Python offer. The target `scene-format` writes both files anew.

/// The schema of scene files, as JSON Schema, draft 7.
std::string SceneSchemaText();

/// A document whose tables between `<!-- fields: STRUCT -->` and `<!-- end -->` are made anew.
/// @throws std::runtime_error for an unknown struct or a table without end
std::string WithFieldTables(const std::string& markdown);

/// A field that an option of the command line sets.
struct SceneSetting
{
  std::vector<std::string> path; ///< keys from the scene to the field
  FieldDescription field;

  std::string Pointer() const; ///< the path as a JSON pointer, "/camera/zoom"
};

std::vector<SceneSetting> SceneSettings();

}

#endif
