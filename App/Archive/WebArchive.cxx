#include "Archive/Archive.h"

#include "Archive/Multipart.h"

#include <QByteArray>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QHostAddress>
#include <QHttpMultiPart>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QString>
#include <QTimer>
#include <QUrl>
#include <QUrlQuery>

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

namespace varimarch
{

namespace
{

/// A request to a server of DICOMweb, which is waited for, with a limit of silence.
class WebRequest
{
public:
  /// @param path  below the URL of the archive, with its query
  WebRequest(const ArchiveAddress& address, const QByteArray& authorization, const QString& path);

  void SetHeader(const char* name, const QByteArray& value);

  /// Receives the bytes of an answer as they come.
  using Receiver = std::function<void(QNetworkReply&)>;

  /// Gets an answer whose status is a success.
  /// @throws std::runtime_error, ArchiveCancelled
  void Get(const Receiver& receive, const ArchiveProgress& progress);

  /// Sends a file as the only part of a message, see STOW-RS.
  /// @returns the status of the answer
  int PostFile(const std::string& file, const ArchiveProgress& progress);

  /// Fails with a sentence about the archive.
  [[noreturn]] void Fail(const QString& found) const;

private:
  void Await(QNetworkReply& reply, const Receiver& receive, const ArchiveProgress& progress);
  void CheckAnswer(QNetworkReply& reply) const;

  const ArchiveAddress& address;
  QNetworkAccessManager manager;
  QNetworkRequest request;
};

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
  // Receives what has come. An error is told by its status, so its text, which may have no end,
  // is not waited for.
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

// The most bytes of the answer to a search.
constexpr int MostAnswerBytes = 64 << 20;

bool IsThisComputer(const QUrl& url)
{
  return url.host() == "localhost" || QHostAddress(url.host()).isLoopback();
}

// Values of an attribute of DICOM's JSON (PS3.18 F), joined by commas.
std::string TextOf(const QJsonObject& object, const char* tag)
{
  QStringList texts;
  for (const QJsonValue& value : object[QLatin1String(tag)].toObject()["Value"].toArray())
  {
    texts.append(
      value.isObject() ? value.toObject()["Alphabetic"].toString() : value.toVariant().toString());
  }
  return texts.join(", ").toStdString();
}

// The objects that a search finds.
QJsonArray Search(WebRequest& request, const ArchiveProgress& progress)
{
  QByteArray answer;
  request.SetHeader("Accept", "application/dicom+json");
  request.Get(
    [&](QNetworkReply& reply)
    {
      answer += reply.readAll();
      if (answer.size() > MostAnswerBytes)
      {
        request.Fail("its answer to a search is too long; search for less");
      }
    },
    progress);
  const QJsonDocument document = QJsonDocument::fromJson(answer);
  // A server may say that it found nothing by no text at all.
  if (!document.isArray() && !answer.trimmed().isEmpty())
  {
    request.Fail("its answer to a search is not a list in JSON");
  }
  if (document.array().size() > int(Archive::MostFound))
  {
    request.Fail(
      QStringLiteral("more than %1 entries match; search for less").arg(Archive::MostFound));
  }
  return document.array();
}

QString SearchPath(const QString& path, QUrlQuery query)
{
  query.addQueryItem("limit", QString::number(Archive::MostFound + 1));
  return path + '?' + query.query(QUrl::FullyEncoded);
}

void AddWord(QUrlQuery& query, const QString& name, const std::string& word)
{
  if (!word.empty())
  {
    // QUrlQuery leaves a plus sign, which servers take for a space.
    query.addQueryItem(
      name, QString::fromUtf8(QUrl::toPercentEncoding(QString::fromStdString(word), "*?")));
  }
}

QString PathOf(const std::string& study)
{
  CheckUid(study);
  return QString::fromStdString("/studies/" + study);
}

// The path of a series; of its study if there is none.
QString PathOf(const std::string& study, const std::string& series)
{
  if (series.empty())
  {
    return PathOf(study);
  }
  CheckUid(series);
  return PathOf(study) + QString::fromStdString("/series/" + series);
}

// Makes a sentence about the archive of a fault of its message.
template <class Action>
void Explain(const WebRequest& request, const Action& action)
{
  try
  {
    action();
  }
  catch (const std::runtime_error& fault)
  {
    request.Fail(QString("it sends ") + fault.what());
  }
}

/// An archive that speaks DICOMweb (PS3.18): QIDO-RS, WADO-RS and STOW-RS. It needs a
/// QCoreApplication, and works in the thread that calls it. It follows no redirection, so that a
/// password reaches only the computer that the user has named.
class WebArchive : public Archive
{
public:
  /// @throws std::runtime_error if the password would cross the network in clear text
  WebArchive(const ArchiveAddress& address, const std::string& password);

  void Check(const ArchiveProgress& progress) override;
  std::vector<ArchiveStudy> FindStudies(
    const ArchiveQuery& query, const ArchiveProgress& progress) override;
  std::vector<ArchiveSeries> FindSeries(
    const std::string& study, const ArchiveProgress& progress) override;
  int Fetch(const std::string& study, const std::string& series, const std::string& folder,
    const ArchiveProgress& progress) override;
  void Send(const std::vector<std::string>& files, const ArchiveProgress& progress) override;

private:
  ArchiveAddress address;
  QByteArray authorization; ///< value of the header; empty without a user
};

WebArchive::WebArchive(const ArchiveAddress& address, const std::string& password)
  : address(address)
{
  if (address.user.empty())
  {
    return;
  }
  const QUrl url(QString::fromStdString(address.url));
  if (url.scheme() != "https" && !IsThisComputer(url))
  {
    throw std::runtime_error("Cannot use the archive \"" + address.url +
      "\": expected https for a password, found http, which everybody on the way can read.");
  }
  this->authorization =
    "Basic " + QByteArray::fromStdString(address.user + ':' + password).toBase64();
}

void WebArchive::Check(const ArchiveProgress& progress)
{
  QUrlQuery one;
  one.addQueryItem("limit", "1");
  WebRequest request(this->address, this->authorization, "/studies?" + one.query());
  Search(request, progress);
}

std::vector<ArchiveStudy> WebArchive::FindStudies(
  const ArchiveQuery& query, const ArchiveProgress& progress)
{
  QUrlQuery words;
  AddWord(words, "PatientName", NamePattern(query));
  AddWord(words, "PatientID", query.patientId);
  AddWord(words, "StudyDate", query.dates);
  AddWord(words, "ModalitiesInStudy", query.modality);
  words.addQueryItem("includefield", "StudyDescription");
  words.addQueryItem("includefield", "ModalitiesInStudy");
  WebRequest request(this->address, this->authorization, SearchPath("/studies", words));
  std::vector<ArchiveStudy> studies;
  for (const QJsonValue& value : Search(request, progress))
  {
    const QJsonObject study = value.toObject();
    studies.push_back(
      { TextOf(study, "0020000D"), TextOf(study, "00100010"), TextOf(study, "00100020"),
        TextOf(study, "00080020"), TextOf(study, "00081030"), TextOf(study, "00080061") });
  }
  return studies;
}

std::vector<ArchiveSeries> WebArchive::FindSeries(
  const std::string& study, const ArchiveProgress& progress)
{
  QUrlQuery words;
  words.addQueryItem("includefield", "SeriesDescription");
  WebRequest request(
    this->address, this->authorization, SearchPath(PathOf(study) + "/series", words));
  std::vector<ArchiveSeries> all;
  for (const QJsonValue& value : Search(request, progress))
  {
    const QJsonObject series = value.toObject();
    all.push_back({ TextOf(series, "0020000E"), TextOf(series, "00200011"),
      TextOf(series, "0008103E"), TextOf(series, "00080060"), TextOf(series, "00201209") });
  }
  return all;
}

int WebArchive::Fetch(const std::string& study, const std::string& series,
  const std::string& folder, const ArchiveProgress& progress)
{
  WebRequest request(this->address, this->authorization, PathOf(study, series));
  // The images come as the archive has stored them.
  request.SetHeader("Accept", "multipart/related; type=\"application/dicom\"; transfer-syntax=*");
  std::optional<MultipartWriter> parts;
  request.Get(
    [&](QNetworkReply& reply)
    {
      if (!parts)
      {
        const QByteArray boundary = BoundaryOf(reply.rawHeader("Content-Type"));
        if (boundary.isEmpty())
        {
          request.Fail("it sends images in no form that DICOMweb has");
        }
        parts.emplace(boundary, folder, double(std::filesystem::space(folder).available));
      }
      Explain(request, [&] { parts->Add(reply.readAll()); });
    },
    progress);
  if (parts)
  {
    Explain(request, [&] { parts->Finish(); });
  }
  if (!parts || parts->PartCount() == 0)
  {
    request.Fail("it sends no image");
  }
  return parts->PartCount();
}

void WebArchive::Send(const std::vector<std::string>& files, const ArchiveProgress& progress)
{
  constexpr int Accepted = 202; // some images were not stored
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const double done = double(i) / double(files.size());
    WebRequest request(this->address, this->authorization, "/studies");
    request.SetHeader("Accept", "application/dicom+json");
    const int status = request.PostFile(files[i], [&](double) { return progress(done); });
    if (status == Accepted)
    {
      request.Fail("it has not stored \"" + QString::fromStdString(files[i]) + '"');
    }
  }
}

}

std::unique_ptr<Archive> WebArchiveAt(const ArchiveAddress& address, const std::string& password)
{
  return std::make_unique<WebArchive>(address, password);
}

}
