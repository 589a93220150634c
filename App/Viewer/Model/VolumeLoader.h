#ifndef Varimarch_Viewer_VolumeLoader_h
#define Varimarch_Viewer_VolumeLoader_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/VolumeRequests.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QThread;

namespace varimarch
{

/// Reads volumes and segmentations in a thread, one at a time; a new request replaces the last one.
/// Each request ends with exactly one of the signals Loaded, LabelsLoaded, PossibleLabelsLoaded,
/// SeriesFound, Failed and Cancelled, unless the loader is destroyed first. A thread that does not
/// stop within seconds, because its file is on a disk of the network that is gone, is left alone.
class VolumeLoader : public QObject
{
  Q_OBJECT

public:
  explicit VolumeLoader(QObject* parent = nullptr);
  ~VolumeLoader() override;

  /// Loads a volume, and labels over it, which are left out with a warning if they cannot be read.
  /// A segmentation without its scan gets its own labels. Overlays that cannot be read are left out
  /// with a warning too.
  /// @param series  digest of the DICOM series to load (DigestOfSeries); if empty and there are
  ///                several that are no segmentations, SeriesFound is emitted
  void Load(const VolumeSource& source, const QString& series = {},
    const std::optional<SceneLabels>& labels = {},
    const std::vector<OverlaidVolume>& overlays = {});

  void Load(const VolumeWish& wish);

  /// Loads what files and folders are together, see TogetherDropped.
  void LoadTogether(const std::vector<std::string>& paths);

  /// Loads labels over a scan.
  void LoadLabels(const SceneLabels& labels, std::shared_ptr<const Study> scan);

  /// Loads a file that may be a segmentation of one of several scans: of one with the grid of the
  /// file, or else of the first that it fits. Emits LabelsLoaded if the file says that its values
  /// are labels, PossibleLabelsLoaded if they could be, and otherwise Loaded.
  void LoadBeside(const std::string& path, const std::vector<std::shared_ptr<const Study>>& scans);

  /// Returns immediately. The thread stops at its next progress report; Cancelled is emitted after
  /// two seconds even if there is none.
  void Cancel();

  bool IsLoading() const { return this->thread != nullptr; }

signals:
  /// @param part  fraction of the work that is done, [0, 1]
  void Progress(double part);
  void Loaded(const varimarch::VolumeSource& source, std::shared_ptr<const varimarch::Study> study);
  /// Emitted before Loaded for a volume without labels and overlays whose first opening takes long.
  /// @param study  a coarse copy of the volume
  void Previewed(
    const varimarch::VolumeSource& source, std::shared_ptr<const varimarch::Study> study);
  /// @param study  the scan with the labels
  void LabelsLoaded(
    const varimarch::SceneLabels& labels, std::shared_ptr<const varimarch::Study> study);
  /// @param own  the same file as a volume of its own
  void PossibleLabelsLoaded(const varimarch::SceneLabels& labels,
    std::shared_ptr<const varimarch::Study> study, std::shared_ptr<const varimarch::Study> own);
  /// Emitted before Loaded or SeriesFound if a folder also holds segmentations.
  void SegmentationsFound(const std::vector<varimarch::SeriesSummary>& segmentations);
  /// Emitted for several DICOM series if none was requested or the requested one is missing.
  void SeriesFound(
    const varimarch::FileSource& source, const std::vector<varimarch::SeriesSummary>& series);
  /// @param reason  one sentence
  void Failed(const QString& reason);
  void Cancelled();

private:
  struct Task;

  static void Run(Task& task);

  /// Reads in the thread, and shows a coarse copy.
  using ReadAndShow = std::function<Found(const LoadObserver&, const ShowPreview&)>;

  void StartShowing(const ReadAndShow& read);
  void Start(std::shared_ptr<Task> request);
  void Finish();
  void EndCancelled();
  std::shared_ptr<Task> LeaveThread();
  void Report(const Task& ended);

  QThread* thread = nullptr;
  std::shared_ptr<Task> task;
};

}

#endif
