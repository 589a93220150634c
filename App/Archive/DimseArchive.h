#ifndef Varimarch_Archive_DimseArchive_h
#define Varimarch_Archive_DimseArchive_h

#include "Archive/Archive.h"

namespace varimarch
{

/// An archive that speaks DICOM's own protocol (PS3.7), by DCMTK: C-ECHO, C-FIND in the model
/// "Study Root", C-GET or C-MOVE, and C-STORE. Images are written as they come, and parsed by
/// nobody.
class DimseArchive : public Archive
{
public:
  explicit DimseArchive(const ArchiveAddress& address);

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
};

}

#endif
