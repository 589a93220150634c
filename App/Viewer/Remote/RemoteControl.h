#ifndef Varimarch_Viewer_RemoteControl_h
#define Varimarch_Viewer_RemoteControl_h

#include "Scene/Json/RemoteMessage.h"

#include <QLocalServer>
#include <QObject>
#include <QString>

class QLocalSocket;

namespace varimarch
{

class MainWindow;

/// Lets scripts of the same user read and change the look of a window, by the messages of
/// RemoteMessage.h. Listens only when asked to.
class RemoteControl : public QObject
{
  Q_OBJECT

public:
  explicit RemoteControl(MainWindow* window);

  /// Listens to a local socket that only the current user can open.
  /// @param name  of a socket in the folder for temporary files, or its path
  /// @throws std::runtime_error if that is impossible
  void Listen(const QString& name);

private:
  void Accept();
  void Read(QLocalSocket* socket);
  std::string AnswerTo(const std::string& text);
  std::string Answer(const RemoteRequest& request);
  std::string Status() const;

  MainWindow* window;
  QLocalServer server;
  QString failure; ///< reason of the last failure to open; empty if a volume was opened since
};

}

#endif
