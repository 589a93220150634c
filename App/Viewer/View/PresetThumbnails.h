#ifndef Varimarch_Viewer_PresetThumbnails_h
#define Varimarch_Viewer_PresetThumbnails_h

#include "Viewer/Model/SceneModel.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <memory>
#include <vector>

class QThread;

namespace varimarch
{

/// Renders thumbnails of a volume with different presets. A thread renders them one after the other
/// from a small copy of the volume, so that they cost the window little time and memory.
class PresetThumbnails : public QObject
{
  Q_OBJECT

public:
  explicit PresetThumbnails(QObject* parent = nullptr);
  ~PresetThumbnails() override;

  /// Starts over. No thumbnails of earlier calls are emitted afterwards.
  /// @param presets  in units of the data
  void Draw(const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels);

  /// Pauses briefly before the next thumbnail, because the user is working.
  void Rest();

signals:
  /// @param index  of the preset
  void Drawn(int index, const QImage& picture);

private:
  struct Task;

  void Start();
  void Finish();
  void Run(const std::shared_ptr<Task>& task);

  QThread* thread = nullptr;
  std::shared_ptr<Task> task;   ///< the latest request
  std::shared_ptr<Task> atWork; ///< running in the thread
};

}

#endif
