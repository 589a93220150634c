#ifndef Varimarch_Viewer_OverlayTimes_h
#define Varimarch_Viewer_OverlayTimes_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SizedTimes.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

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

}

#endif
