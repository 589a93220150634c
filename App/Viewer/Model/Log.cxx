#include "Viewer/Model/Log.h"

#include <QDir>
#include <QSysInfo>
#include <QtGlobal>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkVersion.h>

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <regex>
#include <sstream>

namespace varimarch
{

namespace
{

constexpr std::size_t LargestFileBytes = 512 * 1024;
constexpr std::size_t FilesBefore = 3;

std::shared_ptr<spdlog::logger>& TheLog()
{
  static std::shared_ptr<spdlog::logger> log;
  return log;
}

void Note(const std::string& line)
{
  if (const auto log = TheLog())
  {
    log->info(line);
  }
}

QtMessageHandler printing = nullptr;

// A message may contain a file name, so only its category is logged.
void NoteQtMessage(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
  if (type != QtDebugMsg && type != QtInfoMsg)
  {
    Note("message of Qt, category " + std::string(context.category ? context.category : "none"));
  }
  printing(type, context, message);
}

// Logs the place of a message: "ERROR: In /build/vtkThing.cxx, line 12 ..." gives "vtkThing.cxx,
// line 12".
class NotingOutputWindow : public vtkOutputWindow
{
public:
  static NotingOutputWindow* New();
  vtkTypeMacro(NotingOutputWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    NotePlace(text);
    this->Superclass::DisplayErrorText(text);
  }

  void DisplayGenericWarningText(const char* text) override
  {
    NotePlace(text);
    this->Superclass::DisplayGenericWarningText(text);
  }

  void DisplayWarningText(const char* text) override
  {
    NotePlace(text);
    this->Superclass::DisplayWarningText(text);
  }

private:
  static void NotePlace(const std::string& text)
  {
    static const std::regex pattern("^(?:[\\w ]+: )?In (?:[^,\\n]*/)?(\\w+\\.\\w+, line \\d+)");
    std::smatch place;
    const bool isKnown = std::regex_search(text, place, pattern);
    Note("message of VTK from " + (isKnown ? place[1].str() : "an unknown place"));
  }
};

vtkStandardNewMacro(NotingOutputWindow);

}

QString LogFileIn(const QString& folder)
{
  return folder + "/varimarch-viewer.log";
}

void StartLog(const QString& folder)
{
  QDir().mkpath(folder);
  try
  {
    const auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(
      LogFileIn(folder).toStdString(), LargestFileBytes, FilesBefore);
    TheLog() = std::make_shared<spdlog::logger>("varimarch", sink);
    TheLog()->flush_on(spdlog::level::info);
  }
  catch (const spdlog::spdlog_ex&)
  {
    // If the folder is not writable, the program runs without a log.
    return;
  }
  Note("program started on " + QSysInfo::prettyProductName().toStdString() + ", Qt " + qVersion() +
    ", VTK " + vtkVersion::GetVTKVersion());
  if (!printing)
  {
    printing = qInstallMessageHandler(NoteQtMessage);
    vtkNew<NotingOutputWindow> window;
    vtkOutputWindow::SetInstance(window);
  }
}

void LogEvent(Literal event, std::initializer_list<LogNumber> numbers)
{
  std::ostringstream line;
  line << event.Text();
  for (const LogNumber& number : numbers)
  {
    line << ", " << number.name.Text() << ' ' << number.value;
  }
  Note(line.str());
}

}
