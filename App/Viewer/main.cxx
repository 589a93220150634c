// varimarch-viewer: opens a volume in a window.

#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

int main(int argumentCount, char** arguments)
{
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argumentCount, arguments);
  QCoreApplication::setApplicationName("varimarch-viewer");
  QCoreApplication::setOrganizationName("varimarch");
  QCoreApplication::setApplicationVersion(VARIMARCH_VERSION);

  varimarch::Speak(varimarch::ChosenLanguage(), &application);

  QCommandLineParser parser;
  parser.setApplicationDescription(
    "Looks into CT and MR volumes, with an error that is promised. Not for diagnostic use.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("volume",
    "A volume file, a folder with a DICOM series, or a saved session, to open.", "[volume]");
  parser.process(application);

  varimarch::ApplyTheme(varimarch::ChosenTheme());
  varimarch::StartLog(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  varimarch::MainWindow window;
  window.show();
  window.ShowNoticeOnce();
  if (!parser.positionalArguments().isEmpty())
  {
    window.Open(parser.positionalArguments().first());
  }
  else
  {
    window.OfferAutosaved();
  }
  return QApplication::exec();
}
