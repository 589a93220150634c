#ifndef Varimarch_Viewer_TimeSeries_h
#define Varimarch_Viewer_TimeSeries_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/OverlayTimes.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SizedTimes.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace varimarch
{

/// The times of the scan that is shown. It follows the time that the scene names: it reads that one
/// in the background, then those around it, gives them to the model, and counts the values of all.
/// Times whose voxels stay in their file are only read when they are chosen, and are not counted.
class TimeSeries : public QObject
{
  Q_OBJECT

public:
  /// Memory of the times that are kept [bytes]. The chosen time and the next are kept even if they
  /// are larger; one more may be in work.
  static constexpr std::uint64_t MostBytes = std::uint64_t(1) << 30;

  explicit TimeSeries(SceneModel* model, QObject* parent = nullptr);

  /// Changes the memory of the times that are kept.
  void SetMostBytes(std::uint64_t bytes);

  /// True if the time that the scene names is shown, by the volumes over the scan too.
  bool IsShown() const { return this->IsScanShown() && this->overlays.AreShown(); }

  /// The times in memory, by their numbers.
  const std::map<int, LoadedVolume>& Kept() const { return this->kept; }

signals:
  /// Other times are in memory.
  void KeptChanged();

  /// The chosen time cannot be read, and that before it is chosen again.
  /// @param reason  one sentence
  void Failed(const QString& reason);

private:
  struct Found;

  void Follow(ScenePart part);
  void Begin();
  void ShowChosen();
  void ReadNext();
  void Take(int time, Found found);
  void DropOthers();
  void Leave(const QString& reason);
  int Count() const;
  bool IsScanShown() const;
  bool AreCounted() const;
  std::vector<int> Needed() const;
  std::optional<int> NextToRead() const;

  SceneModel* model;
  OverlayTimes overlays;
  BackgroundTask task;
  QTimer showing; ///< waits until everyone knows the change of the model
  std::uint64_t mostBytes = MostBytes;
  std::shared_ptr<SizedTimes> reader; ///< null for a scan with a single time
  std::map<int, LoadedVolume> kept;
  std::set<int> counted;
  std::set<int> failed;
  std::shared_ptr<const ImageStatistics> sum; ///< counts of the times in `counted`
  int reading = 0;                            ///< the time that the task reads, or read last
};

}

#endif
