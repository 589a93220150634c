#include "Archive/Archive.h"

#include <QFile>
#include <QSslCertificate>
#include <QSslKey>
#include <QUrl>

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr std::size_t LongestTitle = 16;
constexpr std::size_t LongestUid = 64;

[[noreturn]] void FailOnAddress(
  const std::string& url, const std::string& expected, const std::string& found)
{
  throw std::invalid_argument(
    "Cannot use the archive \"" + url + "\": expected " + expected + ", found " + found + ".");
}

bool IsTitle(const std::string& text)
{
  const auto isAllowed = [](char letter)
  { return letter > 0x20 && letter < 0x7f && letter != '\\'; };
  return !text.empty() && text.size() <= LongestTitle &&
    std::all_of(text.begin(), text.end(), isAllowed);
}

QUrl UrlOf(const ArchiveAddress& address)
{
  return QUrl(QString::fromStdString(address.url), QUrl::StrictMode);
}

// True if a file holds a certificate and a private key that can be read without a password.
bool HoldsOwnCertificate(const std::string& path)
{
  QFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::ReadOnly))
  {
    return false;
  }
  const QByteArray text = file.readAll();
  const auto holdsKey = [&text](QSsl::KeyAlgorithm kind) { return !QSslKey(text, kind).isNull(); };
  return !QSslCertificate::fromData(text).isEmpty() && (holdsKey(QSsl::Rsa) || holdsKey(QSsl::Ec));
}

void CheckCertificates(const ArchiveAddress& address, const DimseEndpoint& endpoint)
{
  // DCMTK does not compare the host with the name in the certificate.
  if (endpoint.isEncrypted && address.certificate.empty())
  {
    FailOnAddress(
      address.url, "a file with the certificate of the archive or of its authority", "none");
  }
  // We are the server of the connection in which images arrive.
  if (endpoint.isEncrypted && address.returnPort != 0 && address.ownCertificate.empty())
  {
    FailOnAddress(address.url, "a file with our own certificate for encrypted C-MOVE", "none");
  }
  if (!endpoint.isEncrypted && !address.ownCertificate.empty())
  {
    FailOnAddress(address.url, "dicoms: for a certificate of our own", "dicom:");
  }
  if (!address.ownCertificate.empty() && !HoldsOwnCertificate(address.ownCertificate))
  {
    FailOnAddress(address.url,
      "a certificate and its private key without a password in PEM in \"" + address.ownCertificate +
        '"',
      "none");
  }
}

}

bool IsDimse(const ArchiveAddress& address)
{
  const QString scheme = UrlOf(address).scheme();
  return scheme == "dicom" || scheme == "dicoms";
}

DimseEndpoint DimseEndpointOf(const ArchiveAddress& address)
{
  const QUrl url = UrlOf(address);
  const std::string title = url.userName(QUrl::FullyDecoded).toStdString();
  if (!IsTitle(title))
  {
    FailOnAddress(address.url,
      "the archive's application entity title before '@', of 1 to 16 characters",
      title.empty() ? "none" : '"' + title + '"');
  }
  if (url.port() < 1)
  {
    FailOnAddress(address.url, "a port behind the host, such as :4242", "none");
  }
  return { title, url.host().toStdString(), url.port(), url.scheme() == "dicoms" };
}

void CheckAddress(const ArchiveAddress& address)
{
  const QUrl url = UrlOf(address);
  const bool isWeb = url.scheme() == "http" || url.scheme() == "https";
  if (!url.isValid() || url.host().isEmpty() || !(isWeb || IsDimse(address)))
  {
    FailOnAddress(address.url, "a URL such as dicom://ARCHIVE@host:4242 or https://host/dicom-web",
      "another text");
  }
  if (!url.password().isEmpty() || (isWeb && !url.userName().isEmpty()))
  {
    // The message does not repeat the password.
    FailOnAddress(url.toDisplayString(QUrl::RemoveUserInfo).toStdString(),
      "no name and no password in the URL", "some");
  }
  const QString certificate = QString::fromStdString(address.certificate);
  if (!certificate.isEmpty() && QSslCertificate::fromPath(certificate).isEmpty())
  {
    FailOnAddress(address.url, "a certificate in PEM in \"" + address.certificate + '"', "none");
  }
  if (isWeb)
  {
    return;
  }
  const DimseEndpoint endpoint = DimseEndpointOf(address);
  if (!IsTitle(address.ownTitle))
  {
    FailOnAddress(address.url, "an own application entity title of 1 to 16 characters",
      '"' + address.ownTitle + '"');
  }
  CheckCertificates(address, endpoint);
}

void CheckUid(const std::string& text)
{
  const bool isUid = !text.empty() && text.size() <= LongestUid &&
    text.find_first_not_of("0123456789.") == std::string::npos;
  if (!isUid)
  {
    throw std::runtime_error("Cannot ask for \"" + text.substr(0, LongestUid) +
      "\": expected a UID of digits and dots, found another text.");
  }
}

std::string NamePattern(const ArchiveQuery& query)
{
  const std::string& name = query.patientName;
  return name.empty() || name.find_first_of("*?") != std::string::npos ? name : name + '*';
}

std::unique_ptr<Archive> ArchiveAt(const ArchiveAddress& address, const std::string& password)
{
  CheckAddress(address);
  if (IsDimse(address))
  {
    return DimseArchiveAt(address);
  }
  return WebArchiveAt(address, password);
}

}
