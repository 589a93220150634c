#include "Viewer/Model/Log.h"

#include "Readers/Parsing/VtkMessages.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QMutex>
#include <QMutexLocker>
#include <QSysInfo>
#include <QtGlobal>

#include <vtkVersion.h>

#include <iostream>
#include <memory>
#include <regex>
#include <sstream>

namespace varimarch
{

namespace
{

/// A file of lines with their times. Once it is full, it becomes the first of the files before it.
/// Any thread may add lines.
class RotatingFile
{
public:
  explicit RotatingFile(const QString& path)
    : file(path)
  {
    this->Open();
  }

  bool IsOpen() const { return this->file.isOpen(); }

  void Add(const std::string& line)
  {
    const QMutexLocker lock(&this->mutex);
    const QByteArray bytes =
      QDateTime::currentDateTime().toString("[yyyy-MM-dd hh:mm:ss.zzz] ").toUtf8() +
      QByteArray::fromStdString(line) + '\n';
    if (this->file.size() + bytes.size() > LargestBytes)
    {
      this->Rotate();
    }
    if (this->file.isOpen()) // otherwise QFile would warn, and the warning be logged
    {
      this->file.write(bytes);
      this->file.flush();
    }
  }

private:
  static constexpr qint64 LargestBytes = 512 * 1024;
  static constexpr int FilesBefore = 3;

  void Open() { this->file.open(QIODevice::WriteOnly | QIODevice::Append); }

  /// The path of the file that was full so many files ago: "name.1.log".
  QString PathBefore(int files) const
  {
    const QFileInfo info(this->file.fileName());
    return files == 0
      ? info.filePath()
      : QString("%1/%2.%3.%4")
          .arg(info.path(), info.completeBaseName(), QString::number(files), info.suffix());
  }

  void Rotate()
  {
    this->file.close();
    QFile::remove(this->PathBefore(FilesBefore));
    for (int files = FilesBefore; files > 0; --files)
    {
      QFile::rename(this->PathBefore(files - 1), this->PathBefore(files));
    }
    this->Open();
  }

  QMutex mutex;
  QFile file;
};

std::unique_ptr<RotatingFile>& TheLog()
{
  static std::unique_ptr<RotatingFile> log;
  return log;
}

void Note(const std::string& line)
{
  if (const auto& log = TheLog())
  {
    log->Add(line);
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
// line 12". VTK's log prints it.
void NoteVtkMessage(const VtkMessage& message)
{
  if (message.kind == VtkMessage::Kind::Text)
  {
    std::cerr << message.text;
    return;
  }
  static const std::regex pattern("^(?:[\\w ]+: )?In (?:[^,\\n]*/)?(\\w+\\.\\w+, line \\d+)");
  std::smatch place;
  const bool isKnown = std::regex_search(message.text, place, pattern);
  Note("message of VTK from " + (isKnown ? place[1].str() : "an unknown place"));
}

}

QString LogFileIn(const QString& folder)
{
  return folder + "/varimarch-viewer.log";
}

void StartLog(const QString& folder)
{
  QDir().mkpath(folder);
  TheLog() = std::make_unique<RotatingFile>(LogFileIn(folder));
  if (!TheLog()->IsOpen())
  {
    TheLog().reset(); // the folder is not writable: the program runs without a log
    return;
  }
  Note("program started on " + QSysInfo::prettyProductName().toStdString() + ", Qt " + qVersion() +
    ", VTK " + vtkVersion::GetVTKVersion());
  if (!printing)
  {
    printing = qInstallMessageHandler(NoteQtMessage);
    static VtkMessages messages(&NoteVtkMessage);
    messages.ObserveOutput();
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
