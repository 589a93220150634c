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

/// Draws small pictures of a volume as presets show it, one after the other in a thread of its own,
/// with a small copy of the volume, so that neither the window nor its memory feel it.
class PresetThumbnails : public QObject
{
  Q_OBJECT

public:
  explicit PresetThumbnails(QObject* parent = nullptr);
  ~PresetThumbnails() override;

  /// Begins anew: of earlier ones none comes any more.
  /// @param presets  in units of the data
  void Draw(const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels);

  /// Waits for a moment before the next one, because somebody is at work.
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
  std::shared_ptr<Task> task;   ///< the last that was wanted
  std::shared_ptr<Task> atWork; ///< in the thread
};

}

#endif
