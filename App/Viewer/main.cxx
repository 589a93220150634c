// varimarch-viewer shows a volume in a window.

#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <iterator>

namespace
{

void AddOptions(QCommandLineParser& parser)
{
  parser.setApplicationDescription(
    "Shows CT and MR volumes with a promised error. Not for diagnostic use.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("volume",
    "A volume file, a folder with a DICOM series, or a saved session, to open.", "[volume]");
}

// Prints help or version, if requested, and ends the program. This needs no display, whereas
// QApplication would require one. Qt's own options are ignored.
void AnswerWithoutDisplay(int argumentCount, char** arguments)
{
  QStringList words;
  std::transform(arguments, arguments + argumentCount, std::back_inserter(words),
    [](const char* word) { return QString::fromLocal8Bit(word); });
  QCommandLineParser parser;
  AddOptions(parser);
  parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
  parser.parse(words);
  if (parser.isSet("help") || parser.isSet("help-all") || parser.isSet("version"))
  {
    const QCoreApplication application(argumentCount, arguments);
    parser.isSet("version") ? parser.showVersion() : parser.showHelp();
  }
}

}

int main(int argumentCount, char** arguments)
{
  QCoreApplication::setApplicationName("varimarch-viewer");
  QCoreApplication::setOrganizationName("varimarch");
  QCoreApplication::setApplicationVersion(VARIMARCH_VERSION);
  AnswerWithoutDisplay(argumentCount, arguments);

  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argumentCount, arguments);
  varimarch::Speak(varimarch::ChosenLanguage(), &application);

  QCommandLineParser parser;
  AddOptions(parser);
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
