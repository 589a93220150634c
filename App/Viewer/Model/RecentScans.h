#ifndef Varimarch_Viewer_RecentScans_h
#define Varimarch_Viewer_RecentScans_h

#include "Viewer/Model/SceneModel.h"

#include <QSettings>
#include <QString>
#include <QVector>

namespace varimarch
{

/// A scan that was opened, for a menu. Names of files and folders may name a patient; its label
/// says what it is and when it was opened instead.
struct RecentScan
{
  QString path;
  QString label; ///< "CT, 256 x 256 x 108, opened 21 Nov 2026 21:08"
};

/// The last scans that were opened, the latest first, kept from one run of the program to the next.
class RecentScans
{
public:
  static constexpr int Most = 8;

  QVector<RecentScan> List() const;
  void Add(const QString& path, const Study& study);
  void Clear();

private:
  void Keep(const QVector<RecentScan>& scans);

  QSettings settings;
};

}

#endif
