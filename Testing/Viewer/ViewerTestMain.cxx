// A main() for tests of the viewer: widgets are drawn into memory unless a platform is asked for.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cstdlib>

int main(int argumentCount, char** arguments)
{
  testing::InitGoogleTest(&argumentCount, arguments);
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  // Nothing of the user's is read or written.
  const QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argumentCount, arguments);
  QCoreApplication::setOrganizationName("varimarch");
  QCoreApplication::setApplicationName("viewer-tests");
  return RUN_ALL_TESTS();
}
