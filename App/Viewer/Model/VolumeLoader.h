#ifndef Varimarch_Viewer_VolumeLoader_h
#define Varimarch_Viewer_VolumeLoader_h

#include "Viewer/Model/SceneModel.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <vector>

class QThread;

namespace varimarch
{

/// Reads volumes in a thread, one at a time; a new request replaces the last one. Each Load ends
/// with exactly one of the signals Loaded, SeriesFound, Failed and Cancelled, unless the loader is
/// destroyed first.
class VolumeLoader : public QObject
{
  Q_OBJECT

public:
  explicit VolumeLoader(QObject* parent = nullptr);
  ~VolumeLoader() override;

  /// @param series  digest of the DICOM series to load (DigestOfSeries); if empty and there are
  ///                several, SeriesFound is emitted
  void Load(const VolumeSource& source, const QString& series = {});

  /// Returns immediately; the thread stops at its next progress report.
  void Cancel();

  bool IsLoading() const { return this->thread != nullptr; }

signals:
  /// @param part  fraction of the work that is done, [0, 1]
  void Progress(double part);
  void Loaded(const varimarch::VolumeSource& source, std::shared_ptr<const varimarch::Study> study);
  /// Emitted for several DICOM series if none was requested or the requested one is missing.
  void SeriesFound(
    const varimarch::FileSource& source, const std::vector<varimarch::SeriesSummary>& series);
  /// @param reason  one sentence
  void Failed(const QString& reason);
  void Cancelled();

private:
  struct Task;

  void Run(Task& task);
  void Read(Task& task);
  void Finish();

  QThread* thread = nullptr;
  std::shared_ptr<Task> task;
};

}

#endif
