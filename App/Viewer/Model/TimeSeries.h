#ifndef Varimarch_Viewer_TimeSeries_h
#define Varimarch_Viewer_TimeSeries_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace varimarch
{

/// Lets the volumes over the first one follow its time, if they have as many times: reads the time
/// that the scene names in the background, and gives it to the model. Only one time of each is in
/// memory.
class OverlayTimes : public QObject
{
  Q_OBJECT

public:
  explicit OverlayTimes(SceneModel* model, QObject* parent = nullptr);

  /// True if all volumes that follow show the time that the scene names, or cannot be read.
  bool AreShown() const { return !this->NextToRead(); }

signals:
  /// A time of a volume cannot be read, and the volume keeps the time before.
  /// @param reason  one sentence
  void Failed(const QString& reason);

private:
  /// Identifies a volume at all of its times.
  using Volume = std::shared_ptr<LabelGuard>;

  void Follow(ScenePart part);
  void ForgetRemoved();
  void ReadNext();
  void Leave(const QString& reason);
  /// The number of a volume that shows another time than it should; empty if there is none.
  std::optional<int> NextToRead() const;
  std::shared_ptr<SizedTimes> ReaderOf(int volume);

  SceneModel* model;
  BackgroundTask task;
  QTimer reading; ///< waits until everyone knows the change of the model
  std::map<Volume, std::shared_ptr<SizedTimes>> readers;
  std::set<std::pair<Volume, int>> failed; ///< times that cannot be read
  std::pair<Volume, int> last;             ///< the time that the task reads, or read last
};

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
