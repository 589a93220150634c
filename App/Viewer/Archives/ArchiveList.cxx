#include "Viewer/Archives/ArchiveList.h"

#include <QCoreApplication>
#include <QFile>
#include <QInputDialog>
#include <QSettings>

namespace varimarch
{

namespace
{

const QString ArchivesKey = QStringLiteral("archives");

}

QVector<NamedArchive> KeptArchives()
{
  QVector<NamedArchive> archives;
  QSettings settings;
  const int count = settings.beginReadArray(ArchivesKey);
  for (int i = 0; i < count; ++i)
  {
    settings.setArrayIndex(i);
    const auto text = [&](const char* key) { return settings.value(key).toString().toStdString(); };
    NamedArchive archive;
    archive.name = settings.value("name").toString();
    archive.address.url = text("url");
    archive.address.ownTitle = text("ownTitle");
    archive.address.certificate = text("certificate");
    archive.address.ownCertificate = text("ownCertificate");
    archive.address.returnPort = settings.value("returnPort").toInt();
    archive.address.user = text("user");
    archives.append(archive);
  }
  return archives;
}

void KeepArchives(const QVector<NamedArchive>& archives)
{
  QSettings settings;
  settings.remove(ArchivesKey);
  settings.beginWriteArray(ArchivesKey, archives.size());
  for (int i = 0; i < archives.size(); ++i)
  {
    settings.setArrayIndex(i);
    const ArchiveAddress& address = archives[i].address;
    settings.setValue("name", archives[i].name);
    settings.setValue("url", QString::fromStdString(address.url));
    settings.setValue("ownTitle", QString::fromStdString(address.ownTitle));
    settings.setValue("certificate", QString::fromStdString(address.certificate));
    settings.setValue("ownCertificate", QString::fromStdString(address.ownCertificate));
    settings.setValue("returnPort", address.returnPort);
    settings.setValue("user", QString::fromStdString(address.user));
  }
  settings.endArray();
  settings.sync();
  QFile::setPermissions(settings.fileName(), QFile::ReadOwner | QFile::WriteOwner);
}

std::optional<std::string> PasswordOf(const NamedArchive& archive, QWidget* parent)
{
  if (archive.address.user.empty())
  {
    return std::string();
  }
  bool isGiven = false;
  const QString password =
    QInputDialog::getText(parent, QCoreApplication::translate("ArchiveList", "Password"),
      QCoreApplication::translate("ArchiveList", "Password of %1 for %2. It is not kept.")
        .arg(QString::fromStdString(archive.address.user), archive.name),
      QLineEdit::Password, {}, &isGiven);
  return isGiven ? std::optional(password.toStdString()) : std::nullopt;
}

}
