#ifndef Varimarch_Viewer_OwnPresets_h
#define Varimarch_Viewer_OwnPresets_h

#include "Scene/Scene.h"

#include <QString>
#include <QStringList>

namespace varimarch
{

/// Looks that the user has kept: each is a file in a folder, under its name. Whoever puts a file of
/// a look there has it in the list as well.
///
/// What changes the folder throws std::runtime_error with one sentence when it cannot be done.
class OwnPresets
{
public:
  explicit OwnPresets(const QString& folder);

  /// In the order of the alphabet.
  QStringList Names() const;

  /// @throws std::runtime_error that names the file and what is wrong with it
  Look Read(const QString& name) const;

  /// Keeps a look under a name that none has yet, and returns that name.
  QString Keep(const Look& look);

  void Rename(const QString& name, const QString& newName);
  void Remove(const QString& name);

private:
  QString PathOf(const QString& name) const;

  QString folder;
};

}

#endif
