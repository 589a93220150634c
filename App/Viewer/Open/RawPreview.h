#ifndef Varimarch_Viewer_RawPreview_h
#define Varimarch_Viewer_RawPreview_h

#include "Scene/Scene.h"

#include <QFutureWatcher>
#include <QImage>
#include <QObject>

#include <atomic>
#include <optional>

namespace varimarch
{

/// Reads single slices of a raw file in another thread. If several are requested meanwhile, only
/// the latest is read.
class RawPreview : public QObject
{
  Q_OBJECT

public:
  explicit RawPreview(QObject* parent = nullptr);
  ~RawPreview() override;

  /// @param slice  0 <= slice < number of slices in the layout
  void Read(const std::string& path, const RawLayout& layout, int slice);

signals:
  /// @param picture  null if the slice cannot be read
  void Ready(const QImage& picture);

private:
  void Start();
  void Finish();

  QFutureWatcher<QImage> watcher;
  std::atomic<bool> stop{ false };
  std::optional<FileSource> wanted;
};

}

#endif
