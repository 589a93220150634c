#ifndef Varimarch_Viewer_ArchiveList_h
#define Varimarch_Viewer_ArchiveList_h

#include "Archive/ArchiveAddress.h"

#include <QString>
#include <QVector>

#include <optional>
#include <string>

class QWidget;

namespace varimarch
{

/// An archive that the user has set up.
struct NamedArchive
{
  QString name; ///< as the user calls it
  ArchiveAddress address;
};

/// The archives in the settings, which only their user can read. Passwords are not kept.
QVector<NamedArchive> KeptArchives();
void KeepArchives(const QVector<NamedArchive>& archives);

/// Asks for the password of an archive's user; an empty one if it has none.
/// @returns nothing if the user cancels
std::optional<std::string> PasswordOf(const NamedArchive& archive, QWidget* parent);

}

#endif
