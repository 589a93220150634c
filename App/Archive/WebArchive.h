#ifndef Varimarch_Archive_WebArchive_h
#define Varimarch_Archive_WebArchive_h

#include "Archive/Archive.h"

#include <QByteArray>
#include <QString>

namespace varimarch
{

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

}

#endif
