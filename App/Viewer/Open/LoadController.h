#ifndef Varimarch_Viewer_LoadController_h
#define Varimarch_Viewer_LoadController_h

#include "Scene/Volumes/Placing.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Open/LoadRequest.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

class SavedWork;

/// Loads what the user asks for, and shows it in the model: reads one request at a time in the
/// background, and knows what is to be done with its result. A new request replaces the last one.
/// Each ends with exactly one of the signals Opened, Added, FormShown, LabelsShown, SeriesFound,
/// LabelsFound, Failed and Cancelled; with none if the user keeps the scan that is shown or has
/// removed the volume of the labels, or if the controller is destroyed first. A thread that does
/// not stop within seconds, because its file is on a disk of the network that is gone, is left
/// alone.
class LoadController : public QObject
{
  Q_OBJECT

public:
  /// The objects that a controller works with.
  struct Context
  {
    SceneModel* model;
    SavedWork* work; ///< the work on what is shown; renewed when a scan is opened
    /// Asks whether the shown scan can be left. It is called only for scans that turn out to
    /// replace the shown one when they have been read: others are asked about before they start.
    std::function<bool()> mayLeaveScan;
    /// Reads in the thread, as ReadRequest does.
    std::function<LoadResult(const LoadRequest&, const LoadObserver&, const ShowPreview&)> read =
      ReadRequest;
  };

  explicit LoadController(Context context, QObject* parent = nullptr);
  ~LoadController() override;

  void Start(const LoadRequest& request);

  /// True if another scan can be added to the one that is shown.
  bool HasPlaceForScan() const;

  /// Starts to load labels over a volume of the model.
  void StartLabels(const SceneLabels& labels, int volume);

  /// Starts to load a file that may be a segmentation of a volume of the model, first of all of the
  /// one that is edited, or else a new scan.
  void StartDropped(const std::string& path);

  /// Shows the scan rectified, or as scanned: at once if that form is in memory. Does nothing while
  /// something is loaded.
  void ToggleRectified();

  /// Answers LabelsFound: shows the labels over their volume.
  void ShowLabels(const LoadRequest& request, const LoadResult& found);

  /// Answers LabelsFound: shows the file as a scan.
  void ShowAsScan(const LoadRequest& request, const LoadResult& found);

  /// Returns immediately. The thread stops at its next progress report; Cancelled is emitted after
  /// two seconds even if there is none.
  void Cancel();

  bool IsLoading() const { return this->loading.has_value(); }

signals:
  /// @param path  as PathOf returns it
  void Began(const QString& path);
  /// @param part  fraction of the work that is done, [0, 1]
  void Progress(double part);
  void LoadingChanged(bool isLoading);
  /// A coarse copy is shown until the volume has been read, or for good if that is cancelled.
  void Previewed();

  /// A scan is shown in place of the last one.
  /// @param segmentations  in its folder
  void Opened(const varimarch::VolumeSource& source,
    const std::vector<varimarch::SeriesSummary>& segmentations);
  /// A scan is drawn over the one that is shown.
  void Added(const QString& name, varimarch::CommonSpace space);
  /// The scan is shown in its other form.
  void FormShown();
  void LabelsShown(int segmentCount);
  /// There are several DICOM series, and none was requested, or the requested one is missing.
  /// WithSeries makes the request for one of them.
  void SeriesFound(const varimarch::LoadRequest& request, const varimarch::LoadResult& found);
  /// A dropped file could be a segmentation, but does not say so.
  void LabelsFound(const varimarch::LoadRequest& request, const varimarch::LoadResult& found);
  /// @param reason  one sentence
  void Failed(const QString& reason);
  void Cancelled();

private:
  /// A request that is being read.
  struct Loading
  {
    LoadRequest request;
    bool isPreviewed = false; ///< a coarse copy was shown
  };

  Loading End();
  void EndCancelled();
  void Preview(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  void Take(const LoadResult& found);
  void Show(const Loading& ended, const LoadResult& found);
  void Add(const LoadResult& found);
  void Open(const Loading& ended, const LoadResult& found);
  void Exchange(const VolumeSource& source, const std::shared_ptr<const Study>& form);

  Context context;
  BackgroundTask task;
  std::optional<Loading> loading; ///< empty if nothing is loaded
};

}

Q_DECLARE_METATYPE(varimarch::CommonSpace)
Q_DECLARE_METATYPE(varimarch::LoadRequest)
Q_DECLARE_METATYPE(varimarch::LoadResult)

#endif
