#include "Archive/WebArchive.h"

#include "Archive/Multipart.h"
#include "Archive/WebRequest.h"

#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>
#include <QUrlQuery>

#include <filesystem>
#include <optional>
#include <stdexcept>

namespace varimarch
{

namespace
{

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

}

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
