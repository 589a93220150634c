#ifndef Varimarch_Viewer_RecentScans_h
#define Varimarch_Viewer_RecentScans_h

#include "Viewer/Model/SceneModel.h"

#include <QDateTime>
#include <QString>
#include <QVector>

namespace varimarch
{

/// A scan that was opened. Names of files and folders may contain a patient's name; therefore its
/// texts, in the user's language, give the modality, the part of the body, the size and the time of
/// opening.
struct RecentScan
{
  QString path;
  QString series; ///< digest of the DICOM series, see DigestOfSeries; empty if there is only one
  QString modality;
  QString bodyPart; ///< as in DICOM: "HEAD"; empty if unknown
  QString size;     ///< "256 x 256 x 108"
  QDateTime opened;

  QString Title() const;  ///< "CT HEAD, 256 x 256 x 108"
  QString Opened() const; ///< "opened 21 Nov 2026 21:08"
};

/// Identifies a DICOM series without storing its UID, which can be traced to a patient.
QString DigestOfSeries(const std::string& uid);

/// Scans opened most recently, the latest first, kept in the settings.
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
