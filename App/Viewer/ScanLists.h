#ifndef Varimarch_Viewer_ScanLists_h
#define Varimarch_Viewer_ScanLists_h

#include "Viewer/Model/RecentScans.h"

#include <QObject>
#include <QString>

#include <memory>
#include <string>
#include <vector>

class QMainWindow;
class QMenu;

namespace varimarch
{

class PrivateFolder;
class SceneModel;

/// The lists in which the user finds scans: recent ones, the study list, archives; and the list of
/// the attributes of the scan that is shown. Owns the copies of scans that were fetched from an
/// archive.
class ScanLists : public QObject
{
  Q_OBJECT

public:
  ScanLists(SceneModel* model, QMainWindow* window);

  void AddRecentScansTo(QMenu* menu);
  void AddListsTo(QMenu* menu);

  const RecentScans& Recent() const { return this->recentScans; }

  /// Adds a scan that was opened to the recent ones, unless it is temporary.
  void Remember(const FileSource& file, const Study& study);

  /// True for a scan that was fetched from an archive, and is deleted at the end.
  bool IsTemporary(const std::string& path) const;

  /// Deletes such scans.
  void DeleteTemporaryScans() { this->fetched.clear(); }

signals:
  /// @param series  digest of the DICOM series; empty if there is only one
  void ScanWanted(const QString& path, const QString& series);

private:
  void ListRecentScans(QMenu* menu);
  void ShowStudies();
  void ShowArchive();
  void ShowTags();

  SceneModel* model;
  QMainWindow* window;
  RecentScans recentScans;
  std::vector<std::shared_ptr<const PrivateFolder>> fetched;
};

}

#endif
