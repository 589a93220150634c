#ifndef Varimarch_Viewer_OwnPresets_h
#define Varimarch_Viewer_OwnPresets_h

#include "Scene/Scene.h"

#include <QString>
#include <QStringList>

namespace varimarch
{

/// Presets that the user has kept: each is a file in a folder, under its name. Whoever puts a file
/// of a look there has it in the list as well.
///
/// What changes the folder throws std::runtime_error with one sentence when it cannot be done.
class OwnPresets
{
public:
  explicit OwnPresets(const QString& folder);

  /// In the order of the alphabet.
  QStringList Names() const;

  /// @throws std::runtime_error that names the file and what is wrong with it
  Preset Read(const QString& name) const;

  /// Keeps a preset under a name that none has yet, and returns that name.
  QString Keep(const Preset& preset);

  void Rename(const QString& name, const QString& newName);
  void Remove(const QString& name);

private:
  QString PathOf(const QString& name) const;

  QString folder;
};

}

#endif
