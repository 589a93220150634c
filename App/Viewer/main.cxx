// varimarch-viewer shows a volume in a window.

#include "Viewer/AccessibleNames.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Remote/RemoteControl.h"
#include "Viewer/Theme.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/View/VtkPictures.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>
#include <thread>

namespace
{

bool runsEvents = false;

// Handles events until the user quits. Qt calls exit() from within if the display is gone. Threads
// still work on a scan then, under which nothing may be destroyed; the autosaved session is kept.
int RunEvents()
{
  std::atexit(
    []
    {
      if (runsEvents)
      {
        std::_Exit(EXIT_FAILURE);
      }
    });
  runsEvents = true;
  const int code = QApplication::exec();
  runsEvents = false;
  return code;
}

void AddOptions(QCommandLineParser& parser)
{
  parser.setApplicationDescription(
    "Shows CT and MR volumes with a promised error. Not for diagnostic use.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addOption({ "listen",
    "Let scripts of this user change the look through the local socket of this name or path.",
    "name" });
  parser.addPositionalArgument("volume",
    "A volume file, a folder with a DICOM series, the files of a series, or a saved session, to "
    "open.",
    "[volume]...");
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

void PrintFailure(const QString& reason)
{
  std::cerr << "varimarch-viewer: no window can be opened: " << reason.toStdString() << ".\n";
}

// Ends the program with a sentence if there is no display or no plug-in for it. Qt would abort.
void EndOnFatalMessage(QtMsgType type, const QMessageLogContext&, const QString& message)
{
  // The first message names the cause.
  static const QString reason = message.section('\n', 0, 0).trimmed();
  if (type == QtFatalMsg)
  {
    PrintFailure(reason +
      "; start the program in a graphical session, or use the program varimarch, which needs no "
      "display");
    std::_Exit(EXIT_FAILURE);
  }
}

// Ends the program after a moment, even if threads still read or draw a scan. The user's work is in
// files once the window is closed, and nobody waits for theirs.
void EndSoon(int code)
{
  const std::chrono::milliseconds moment(500);
  std::thread(
    [code, moment]
    {
      std::this_thread::sleep_for(moment);
      std::_Exit(code);
    })
    .detach();
}

// Null, with a message, if the window cannot listen to scripts.
std::unique_ptr<varimarch::RemoteControl> ListeningTo(
  const QString& name, varimarch::MainWindow& window)
{
  try
  {
    auto remote = std::make_unique<varimarch::RemoteControl>(&window);
    remote->Listen(name);
    return remote;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "varimarch-viewer: " << problem.what() << "\n";
    return nullptr;
  }
}

// Shows the window until the user closes it. Returns the exit code of the program.
int RunWindow(const QCommandLineParser& parser)
{
  const QString problem = varimarch::OpenGLProblem();
  if (!problem.isEmpty())
  {
    PrintFailure(problem);
    QMessageBox::critical(nullptr, QApplication::applicationName(), problem);
    return EXIT_FAILURE;
  }

  varimarch::ApplyTheme(varimarch::ChosenTheme());
  varimarch::StartLog(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  varimarch::MainWindow window;
  std::unique_ptr<varimarch::RemoteControl> remote; // it leaves before the window, with its socket
  if (parser.isSet("listen"))
  {
    remote = ListeningTo(parser.value("listen"), window);
    if (!remote)
    {
      return EXIT_FAILURE;
    }
  }
  if (varimarch::IsOpenGLOnProcessor())
  {
    window.CentralView()->Ours()->DrawInThread();
  }
  window.show();
  window.ShowNoticeOnce();
  const QStringList paths = parser.positionalArguments();
  if (!paths.isEmpty())
  {
    window.OpenTogether(paths);
  }
  else
  {
    window.OfferAutosaved();
    window.OfferFileAtStart();
  }
  const int code = RunEvents();
  EndSoon(code);
  return code;
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
  format.setOption(QSurfaceFormat::ResetNotification);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  // A file beyond the shell's limit is then an error of the writer.
  std::signal(SIGXFSZ, SIG_IGN);
  const QtMessageHandler printing = qInstallMessageHandler(EndOnFatalMessage);
  QApplication application(argumentCount, arguments);
  qInstallMessageHandler(printing);
  varimarch::Speak(varimarch::ChosenLanguage(), &application);
  varimarch::TellRolesOfViews();

  QCommandLineParser parser;
  AddOptions(parser);
  parser.process(application);

  return RunWindow(parser);
}
