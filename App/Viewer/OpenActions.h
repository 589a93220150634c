#ifndef Varimarch_Viewer_OpenActions_h
#define Varimarch_Viewer_OpenActions_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/Placing.h"
#include "Viewer/Open/LoadRequest.h"

#include <QObject>
#include <QString>

class QMainWindow;
class QMenu;
class QMimeData;

namespace varimarch
{

class Autosave;
class LoadController;
class SaveActions;
class ScanLists;
class SceneModel;

/// Opens scans, sessions and segmentations: asks the user which, and for what a file does not say;
/// lets a LoadController load them; and tells what came of it.
class OpenActions : public QObject
{
  Q_OBJECT

public:
  struct Context
  {
    SceneModel* model;
    LoadController* loader;
    SaveActions* saving;
    ScanLists* lists;
    const Autosave* autosave;
  };

  OpenActions(const Context& context, QMainWindow* window);

  /// Adds the ways to open a scan, to add another one, and to open a segmentation.
  void AddTo(QMenu* menu);
  /// Adds whether a scan is asked for at start, and the memory for volumes.
  void AddSettingsTo(QMenu* menu);

  /// Starts to load a file, a folder with a DICOM series, or a saved session.
  /// @param series  digest of the DICOM series to open; if empty, the user is asked
  void Open(const QString& path, const QString& series = {});

  /// Starts to load the scan that files and folders are together; several series are offered.
  void OpenTogether(const QStringList& paths);

  /// Starts to load a scan whose times are files: those beside this one whose names differ from its
  /// own in their last number, or those in this folder.
  void OpenTimes(const QString& path);

  /// Starts to load a computed volume.
  void OpenSample(const VolumeSource& sample);

  /// Starts to load a scan to be drawn over the one that is shown.
  void AddScan(const QString& path);

  /// Opens files that are dropped on the window. One that is dropped on scans may be a segmentation
  /// of one of them.
  void OpenDropped(const QStringList& paths);

  /// The files and folders of this computer among what is dragged.
  static QStringList LocalFiles(const QMimeData& data);

  /// Offers to restore the session of a program that ended unexpectedly.
  void OfferAutosaved();

  /// Asks for a file if the user has chosen that, and nothing is opened yet.
  void OfferFileAtStart();

  void ChooseFile();
  void ChooseFolder();
  void ChooseFurtherScan();
  void ChooseSegmentation();

signals:
  /// @param reason  one sentence
  void Failed(const QString& reason);

private:
  void Listen();
  void ChooseTimes();
  void ChooseRawFile();
  void FillKinds(QMenu* kinds);
  void FillMemory(QMenu* menu);
  void AskForLayout(const QString& path);
  void AskForSeries(const LoadRequest& request, const LoadResult& found);
  void AskForLabels(const LoadRequest& request, const LoadResult& found);
  void OfferSegmentations(
    const FileSource& folder, const std::vector<SeriesSummary>& segmentations);
  void OpenOffered(const FileSource& folder, const std::vector<SeriesSummary>& offered);
  void TellOpened(const VolumeSource& source, const std::vector<SeriesSummary>& segmentations);
  void TellAdded(const QString& name, CommonSpace space);
  void TellLabels(int segmentCount);
  void TellFailure(const QString& reason);

  Context context;
  QMainWindow* window;
};

}

#endif
