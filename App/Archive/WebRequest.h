#ifndef Varimarch_Archive_WebRequest_h
#define Varimarch_Archive_WebRequest_h

#include "Archive/Archive.h"

#include <QByteArray>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QString>

#include <functional>
#include <memory>

namespace varimarch
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

}

#endif
