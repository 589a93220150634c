#ifndef Varimarch_Testing_PrivateSettings_h
#define Varimarch_Testing_PrivateSettings_h

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

/// Isolates a test from the user's settings and from tests that run at the same time. Create it
/// before the application.
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
