#ifndef Varimarch_Viewer_OwnPresets_h
#define Varimarch_Viewer_OwnPresets_h

#include "Scene/Looks/Presets.h"
#include "Scene/Model/Scene.h"

#include <QString>
#include <QStringList>

#include <string>

namespace varimarch
{

/// Presets that the user has saved, one file each in a folder. Look files that are copied to the
/// folder appear in the list too.
///
/// Functions that change the folder throw std::runtime_error with one sentence on failure.
class OwnPresets
{
public:
  explicit OwnPresets(const QString& folder);

  /// Names in alphabetical order.
  QStringList Names() const;

  /// @throws std::runtime_error that names the file and the fault
  Preset Read(const QString& name) const;

  /// Saves a preset under an unused name and returns that name.
  QString Keep(const Preset& preset);

  void Rename(const QString& name, const QString& newName);
  void Remove(const QString& name);

private:
  QString PathOf(const QString& name) const;

  QString folder;
};

/// Title of a built-in preset in the user's language, such as "Bone". For other looks, their name.
QString PresetTitle(const std::string& name);

/// Reason for a suggested preset, as the end of a sentence in the user's language.
QString SuggestionText(const PresetSuggestion& suggestion);

}

#endif
