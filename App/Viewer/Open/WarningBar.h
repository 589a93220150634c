#ifndef Varimarch_Viewer_WarningBar_h
#define Varimarch_Viewer_WarningBar_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"

#include <QFrame>
#include <QStringList>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace varimarch
{

/// A warning about one of the volumes of a scene, or about its labels.
struct ScanWarning
{
  std::shared_ptr<LabelGuard> volume; ///< the volume, whatever its name; see Study
  QString sentence;
  QString name; ///< the name of a volume over the first one; empty for others

  /// The sentence after the name.
  QString Text() const;

  /// True for the same warning about the same volume, which may have another name by now.
  bool IsThatOf(const ScanWarning& other) const
  {
    return this->volume == other.volume && this->sentence == other.sentence;
  }
};

/// The DICOM series that an image belongs to, with the images beside it.
struct WholeSeries
{
  std::string folder;
  std::string uid;
  int imageCount; ///< at least two
};

/// A bar above the views with warnings about the volumes of a model, and a button for what can be
/// done about them. It stays until the user closes it or another volume is opened.
class WarningBar : public QFrame
{
  Q_OBJECT

public:
  explicit WarningBar(SceneModel* model, QWidget* parent = nullptr);

  /// Looks, in a thread, for the series that a single image belongs to, which may lie beside it,
  /// and offers it.
  void LookForSeries(const VolumeSource& source);

  /// The texts that were shown last, also after the user closed the bar.
  QStringList Texts() const;

signals:
  /// The user wants to see the scan rectified, or as scanned.
  void OtherFormWanted();
  /// @param series  digest of the DICOM series
  void SeriesWanted(const QString& folder, const QString& series);

private:
  void Show(bool isNewVolume);
  void TakeRemedy();

  SceneModel* model;
  BackgroundTask seriesSearch;
  std::optional<WholeSeries> wholeSeries; ///< belongs to the single image that is shown
  std::vector<ScanWarning> shown;
  QLabel* text;
  QPushButton* remedy;
};

}

#endif
