#ifndef Varimarch_Viewer_StartPage_h
#define Varimarch_Viewer_StartPage_h

#include "Scene/Model/Scene.h"
#include "Viewer/Model/RecentScans.h"

#include <QWidget>

class QVBoxLayout;

namespace varimarch
{

/// A computed volume for those without a scan.
VolumeSource SampleTorso();

/// The page of a window without a scan: how to open one, those opened most recently, and samples.
class StartPage : public QWidget
{
  Q_OBJECT

public:
  explicit StartPage(const RecentScans& recentScans, QWidget* parent = nullptr);

signals:
  void FileWanted();
  void FolderWanted();

  /// @param series  digest of the DICOM series; empty if there is only one
  void ScanWanted(const QString& path, const QString& series);

  void SampleWanted(const VolumeSource& sample);
  void TourWanted();

private:
  void AddRecentScans(QVBoxLayout* column, const RecentScans& recentScans);
  void AddSamples(QVBoxLayout* column);
};

}

#endif
