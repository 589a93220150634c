#ifndef Varimarch_Viewer_RecentScans_h
#define Varimarch_Viewer_RecentScans_h

#include "Viewer/Model/SceneModel.h"

#include <QString>
#include <QVector>

namespace varimarch
{

/// A scan that was opened, for a menu. Names of files and folders may name a patient; its label
/// says what it is and when it was opened instead.
struct RecentScan
{
  QString path;
  QString label;  ///< "CT, 256 x 256 x 108, opened 21 Nov 2026 21:08"
  QString series; ///< which of several DICOM series, as DigestOfSeries; else empty
};

/// What tells a DICOM series again without naming it: its UID leads to a patient.
QString DigestOfSeries(const std::string& uid);

/// The last scans that were opened, the latest first, kept from one run of the program to the next.
class RecentScans
{
public:
  static constexpr int Most = 8;

  QVector<RecentScan> List() const;
  void Add(const FileSource& source, const Study& study);
  void Clear();

private:
  static void Keep(const QVector<RecentScan>& scans);
};

}

#endif
