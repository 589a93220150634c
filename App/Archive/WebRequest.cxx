#include "Archive/WebRequest.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QHttpMultiPart>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QTimer>

#include <exception>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr int PollMilliseconds = 50;

QSslConfiguration TrustIn(const ArchiveAddress& address)
{
  QSslConfiguration trust = QSslConfiguration::defaultConfiguration();
  if (!address.certificate.empty())
  {
    trust.addCaCertificates(QSslCertificate::fromPath(QString::fromStdString(address.certificate)));
  }
  return trust;
}

int StatusOf(const QNetworkReply& reply)
{
  return reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
}

bool IsSuccess(int status)
{
  return status / 100 == 2;
}

// The wait for the end of an answer, in a loop of events.
class Awaiting
{
public:
  Awaiting(QNetworkReply& reply, const WebRequest::Receiver& receive,
    const ArchiveProgress& progress, double patience)
    : reply(reply)
    , receive(receive)
    , progress(progress)
    , patience(patience)
  {
    const auto listen = [this](auto signal, auto action)
    { QObject::connect(&this->reply, signal, &this->loop, action); };
    listen(&QNetworkReply::readyRead, [this] { this->Hear(); });
    listen(&QNetworkReply::uploadProgress, [this] { this->silence.restart(); });
    listen(&QNetworkReply::finished, [this] { this->loop.quit(); });
    QObject::connect(&this->poll, &QTimer::timeout, &this->loop, [this] { this->Look(); });
  }

  /// Waits. An exception of the receiver ends the answer.
  /// @returns false if the server is silent for too long
  /// @throws ArchiveCancelled, and what the receiver throws
  bool HasAnswer()
  {
    this->silence.start();
    this->poll.start(PollMilliseconds);
    if (!this->reply.isFinished())
    {
      this->loop.exec();
    }
    if (this->isCancelled)
    {
      throw ArchiveCancelled();
    }
    if (this->isSilent)
    {
      return false;
    }
    this->Hear();
    if (this->problem)
    {
      std::rethrow_exception(this->problem);
    }
    return true;
  }

private:
  // Receives what has come. An error is told by its status, so its text, which may have no end, is
  // not waited for.
  void Hear()
  {
    this->silence.restart();
    if (!IsSuccess(StatusOf(this->reply)))
    {
      this->loop.quit();
      return;
    }
    try
    {
      if (!this->problem && this->reply.bytesAvailable() > 0)
      {
        this->receive(this->reply);
      }
    }
    catch (...)
    {
      this->problem = std::current_exception();
      this->loop.quit();
    }
  }

  void Look()
  {
    this->isCancelled = !this->progress(-1.0);
    this->isSilent = double(this->silence.elapsed()) > 1000.0 * this->patience;
    if (this->isCancelled || this->isSilent)
    {
      this->loop.quit();
    }
  }

  QNetworkReply& reply;
  const WebRequest::Receiver& receive;
  const ArchiveProgress& progress;
  double patience; ///< [s]
  QEventLoop loop;
  QElapsedTimer silence;
  QTimer poll;
  std::exception_ptr problem;
  bool isCancelled = false;
  bool isSilent = false;
};

}

WebRequest::WebRequest(
  const ArchiveAddress& address, const QByteArray& authorization, const QString& path)
  : address(address)
{
  QString base = QString::fromStdString(address.url);
  while (base.endsWith('/'))
  {
    base.chop(1);
  }
  this->request.setUrl(QUrl(base + path));
  this->request.setSslConfiguration(TrustIn(address));
  this->request.setRawHeader("User-Agent", "varimarch");
  if (!authorization.isEmpty())
  {
    this->request.setRawHeader("Authorization", authorization);
  }
  this->request.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
}

void WebRequest::SetHeader(const char* name, const QByteArray& value)
{
  this->request.setRawHeader(name, value);
}

void WebRequest::Fail(const QString& found) const
{
  throw std::runtime_error(
    "The archive \"" + this->address.url + "\" cannot be used: " + found.toStdString() + ".");
}

void WebRequest::Await(
  QNetworkReply& reply, const Receiver& receive, const ArchiveProgress& progress)
{
  Awaiting awaiting(reply, receive, progress, this->address.patience);
  if (!awaiting.HasAnswer())
  {
    this->Fail(QStringLiteral("it has been silent for %1 s").arg(this->address.patience));
  }
}

void WebRequest::CheckAnswer(QNetworkReply& reply) const
{
  const int status = StatusOf(reply);
  if (status == 401 || status == 403)
  {
    this->Fail("it asks for a user and a password, or refuses those that it was given");
  }
  if (status / 100 == 3)
  {
    this->Fail("it sends elsewhere, to \"" +
      reply.header(QNetworkRequest::LocationHeader).toString() +
      "\"; give that URL if you trust it");
  }
  const bool isAnswer = status != 0;
  if (isAnswer && !IsSuccess(status))
  {
    this->Fail(QStringLiteral("it answers with the status %1").arg(status));
  }
  if (reply.error() == QNetworkReply::SslHandshakeFailedError)
  {
    this->Fail("its certificate is not trusted; name the file of the certificate if you trust it");
  }
  if (reply.error() != QNetworkReply::NoError)
  {
    this->Fail(reply.errorString());
  }
}

void WebRequest::Get(const Receiver& receive, const ArchiveProgress& progress)
{
  const std::unique_ptr<QNetworkReply> reply(this->manager.get(this->request));
  this->Await(*reply, receive, progress);
  this->CheckAnswer(*reply);
}

int WebRequest::PostFile(const std::string& file, const ArchiveProgress& progress)
{
  QHttpMultiPart parts(QHttpMultiPart::RelatedType);
  QFile body(QString::fromStdString(file));
  if (!body.open(QIODevice::ReadOnly))
  {
    throw std::runtime_error(
      "Cannot send \"" + file + "\": " + body.errorString().toStdString() + ".");
  }
  QHttpPart part;
  part.setHeader(QNetworkRequest::ContentTypeHeader, "application/dicom");
  part.setBodyDevice(&body);
  parts.append(part);
  this->request.setHeader(QNetworkRequest::ContentTypeHeader,
    "multipart/related; type=\"application/dicom\"; boundary=\"" + parts.boundary() + '"');
  const std::unique_ptr<QNetworkReply> reply(this->manager.post(this->request, &parts));
  this->Await(
    *reply, [](QNetworkReply& answer) { answer.readAll(); }, progress);
  this->CheckAnswer(*reply);
  return StatusOf(*reply);
}

}
