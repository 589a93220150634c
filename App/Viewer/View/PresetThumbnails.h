#ifndef Varimarch_Viewer_PresetThumbnails_h
#define Varimarch_Viewer_PresetThumbnails_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <atomic>
#include <memory>
#include <vector>

namespace varimarch
{

/// Renders thumbnails of a volume with different presets. A thread renders them one after the other
/// from a small copy of the volume, so that they cost the window little time and memory.
class PresetThumbnails : public QObject
{
  Q_OBJECT

public:
  explicit PresetThumbnails(QObject* parent = nullptr);

  /// Starts over. No thumbnails of earlier calls are emitted afterwards.
  /// @param presets  in units of the data
  void Draw(const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels);

  /// Pauses briefly before the next thumbnail, because the user is working.
  void Rest();

signals:
  /// @param index  of the preset
  void Drawn(int index, const QImage& picture);

private:
  BackgroundTask task;
  std::shared_ptr<std::atomic<bool>> rests; ///< asks the latest work to pause
};

}

#endif
