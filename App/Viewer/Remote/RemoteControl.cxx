#include "Viewer/Remote/RemoteControl.h"

#include "Scene/Looks/Presets.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Model/Log.h"

#include <QDir>
#include <QFileInfo>
#include <QLocalSocket>

#include <stdexcept>

namespace varimarch
{

namespace
{

// Property of a socket: the line that it sends is refused already.
constexpr const char* IsRefused = "isRefused";

void Send(QLocalSocket* socket, const std::string& line)
{
  socket->write(QByteArray::fromStdString(line + "\n"));
}

}

RemoteControl::RemoteControl(MainWindow* window)
  : QObject(window)
  , window(window)
{
  this->server.setSocketOptions(QLocalServer::UserAccessOption);
  connect(&this->server, &QLocalServer::newConnection, this, &RemoteControl::Accept);
  connect(window, &MainWindow::OpeningFailed, this,
    [this](const QString& reason) { this->failure = reason; });
  connect(window->Model(), &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (part == ScenePart::Volume)
      {
        this->failure.clear();
      }
    });
}

void RemoteControl::Listen(const QString& name)
{
  // Qt would take the place of a socket that exists.
  const QString path = QDir::temp().absoluteFilePath(name);
  const bool isFree = !QFileInfo::exists(path);
  if (!isFree || !this->server.listen(path))
  {
    const std::string reason =
      isFree ? this->server.errorString().toStdString() : "the file exists already";
    throw std::runtime_error(
      "--listen: expected a free name or path, found " + path.toStdString() + ": " + reason);
  }
  LogEvent("listening to scripts");
}

void RemoteControl::Accept()
{
  while (QLocalSocket* const socket = this->server.nextPendingConnection())
  {
    LogEvent("script connected");
    // A longer line is refused, so more of it need not be kept.
    socket->setReadBufferSize(LongestRemoteMessage + 2);
    connect(socket, &QLocalSocket::readyRead, this, [this, socket] { this->Read(socket); });
    connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
  }
}

void RemoteControl::Read(QLocalSocket* socket)
{
  while (socket->canReadLine())
  {
    std::string line = socket->readLine().toStdString();
    line.pop_back();
    if (socket->property(IsRefused).toBool())
    {
      socket->setProperty(IsRefused, false); // this was the end of a line that is too long
    }
    else
    {
      Send(socket, this->AnswerTo(line));
    }
  }
  if (socket->bytesAvailable() > LongestRemoteMessage)
  {
    const std::string beginning = socket->readAll().toStdString();
    if (!socket->property(IsRefused).toBool())
    {
      Send(socket, this->AnswerTo(beginning));
    }
    socket->setProperty(IsRefused, true);
  }
}

std::string RemoteControl::AnswerTo(const std::string& text)
{
  try
  {
    return this->Answer(RemoteRequestFromText(text));
  }
  catch (const std::exception& problem)
  {
    return RemoteError(problem.what());
  }
}

std::string RemoteControl::Answer(const RemoteRequest& request)
{
  if (request.task == RemoteRequest::Task::ReadStatus)
  {
    return this->Status();
  }
  SceneModel* const model = this->window->Model();
  if (!model->CurrentStudy())
  {
    throw std::runtime_error("message: expected after a volume is shown, found none in the viewer");
  }
  if (request.task == RemoteRequest::Task::ReadLook)
  {
    return RemoteLook(PresetOf(model->EditedScene()));
  }
  model->SetPreset(request.look, tr("look of a script"));
  return RemoteDone();
}

std::string RemoteControl::Status() const
{
  if (this->window->Loader()->IsLoading())
  {
    return RemoteStatus("loading");
  }
  if (!this->failure.isEmpty())
  {
    return RemoteStatus("failed", this->failure.toStdString());
  }
  return RemoteStatus(this->window->Model()->CurrentStudy() ? "shown" : "empty");
}

}
