#ifndef Varimarch_Testing_PrivateSettings_h
#define Varimarch_Testing_PrivateSettings_h

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

/// While it lives, nothing of the user's is read or written, and nothing of another test's that
/// runs at the same time. To be made before the application.
class PrivateSettings
{
public:
  PrivateSettings()
  {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, this->folder.path());
    qputenv("XDG_DATA_HOME", this->folder.filePath("data").toUtf8());
    QCoreApplication::setOrganizationName("varimarch");
    QCoreApplication::setApplicationName("viewer-tests");
  }

private:
  QTemporaryDir folder;
};

#endif
