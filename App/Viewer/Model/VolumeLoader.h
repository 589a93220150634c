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

/// Reads volumes in a thread of its own, one at a time; a new one takes the place of the last.
/// Exactly one of Loaded, SeriesFound, Failed and Cancelled ends what Load began, unless this is
/// destroyed.
class VolumeLoader : public QObject
{
  Q_OBJECT

public:
  explicit VolumeLoader(QObject* parent = nullptr);
  ~VolumeLoader() override;

  /// @param series  the digest (DigestOfSeries) of the one to take of several DICOM series; empty:
  /// it
  ///   is asked for
  void Load(const VolumeSource& source, const QString& series = {});

  /// Returns at once; the thread stops at the next step of its reading.
  void Cancel();

  bool IsLoading() const { return this->thread != nullptr; }

signals:
  /// @param part  of the work that is done, [0, 1]
  void Progress(double part);
  void Loaded(const varimarch::VolumeSource& source, std::shared_ptr<const varimarch::Study> study);
  /// There are several DICOM series, and nothing says which, or not that one which is asked for.
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
