#ifndef Varimarch_Testing_FakeWebArchive_h
#define Varimarch_Testing_FakeWebArchive_h

#include "Viewer/Archives/ArchiveChoice.h"

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QTcpServer>
#include <QTcpSocket>

/// A server of DICOMweb on this computer that answers by a table of paths, and remembers what it
/// was asked. Paths that it does not know get no answer.
class FakeWebArchive : public QTcpServer
{
public:
  FakeWebArchive()
  {
    this->listen(QHostAddress::LocalHost);
    connect(this, &QTcpServer::newConnection, this,
      [this]
      {
        QTcpSocket* const socket = this->nextPendingConnection();
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { this->Read(socket); });
        connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
      });
  }

  QString Url() const { return QStringLiteral("http://127.0.0.1:%1/web").arg(this->serverPort()); }

  /// Sets the answer to requests of a path without its query.
  void Answer(const QString& path, const QByteArray& type, const QByteArray& body)
  {
    this->answers["/web" + path] = "HTTP/1.1 200 OK\r\nContent-Type: " + type +
      "\r\nContent-Length: " + QByteArray::number(body.size()) + "\r\n\r\n" + body;
  }

  QStringList requests; ///< "GET /web/studies?..."
  QByteArray lastBody;  ///< body of the last request that had one

private:
  void Read(QTcpSocket* socket)
  {
    QByteArray& request = this->pending[socket];
    request += socket->readAll();
    const int end = request.indexOf("\r\n\r\n");
    if (end < 0 || request.size() < end + 4 + LengthIn(request.left(end)))
    {
      return;
    }
    const QString line = request.left(request.indexOf(" HTTP/"));
    this->requests.append(line);
    if (request.size() > end + 4)
    {
      this->lastBody = request.mid(end + 4);
    }
    request.clear();
    socket->write(this->answers.value(line.section(' ', 1).section('?', 0, 0)));
  }

  static int LengthIn(const QByteArray& head)
  {
    const int place = head.toLower().indexOf("content-length:");
    return place < 0 ? 0 : head.mid(place + 15).split('\r').first().trimmed().toInt();
  }

  QMap<QString, QByteArray> answers;
  QMap<QTcpSocket*, QByteArray> pending;
};

/// Makes an archive the only one of the user, under the name "hospital".
inline void KeepAsHospital(const QString& url)
{
  varimarch::NamedArchive archive;
  archive.name = "hospital";
  archive.address.url = url.toStdString();
  // GCC 12 wrongly warns of a vector of one made in place.
  QVector<varimarch::NamedArchive> archives;
  archives.append(archive);
  varimarch::KeepArchives(archives);
}

#endif
