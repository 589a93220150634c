#ifndef Varimarch_Viewer_MainWindow_h
#define Varimarch_Viewer_MainWindow_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Model/VolumeLoader.h"
#include "Viewer/Open/WholeSeries.h"

#include <QMainWindow>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QAction;
class QActionGroup;
class QDockWidget;
class QMenu;
class QProgressBar;
class QPushButton;

namespace varimarch
{

class ComparisonView;
class KeyImagesBox;
class SegmentEditor;
class PictureMaker;
class PrivateFolder;
class SliceView;
class StartPage;
class TimeBar;
class TimeCurve;
class TimeSeries;
struct TourStep;
class ViewLayout;
class ViewMenu;
class WarningBar;

/// The main window: menus, views, panels, and the loading of volumes. MainWindowFiles.cxx opens
/// files, MainWindowLoaded.cxx shows them, MainWindowArchives.cxx lists scans and their attributes,
/// MainWindowSegments.cxx shows segmentations, MainWindowVolumes.cxx adds further scans,
/// MainWindowSessions.cxx keeps the user's work, MainWindowTools.cxx sets up the tools.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// Starts to load a file, a folder with a DICOM series, or a saved session.
  /// @param series  digest of the DICOM series to open; if empty, the user is asked
  void Open(const QString& path, const QString& series = {});

  /// Starts to load the scan that files and folders are together; several series are offered.
  void OpenTogether(const QStringList& paths);

  /// Starts to load a scan whose times are files: those beside this one whose names differ from its
  /// own in their last number, or those in this folder.
  void OpenTimes(const QString& path);

  /// Starts to load a scan to be drawn over the one that is shown.
  void AddScan(const QString& path);

  /// Offers to restore the session of a program that ended unexpectedly.
  void OfferAutosaved();

  /// Asks for a file if the user has chosen that, and nothing is opened yet.
  void OfferFileAtStart();

  /// Shows, once per user, the notice that the program is not for diagnostic use.
  void ShowNoticeOnce();

  /// Shows VTK's image beside ours; std::nullopt shows only ours.
  void Compare(std::optional<MapperKind> kind);

  SceneModel* Model() { return &this->model; }
  VolumeLoader* Loader() { return &this->loader; }
  ComparisonView* CentralView() { return this->view; }

signals:
  /// @param reason  one sentence
  void OpeningFailed(const QString& reason);

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void childEvent(QChildEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  /// Remembers the view that was clicked last, or had the keys.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct MenuTool;

  void Listen();
  void MakeViews();
  void MakeStartPage();
  void MakeTimes();
  void MakeFileMenu();
  void MakeArchiveActions(QMenu* menu);
  void ShowArchive();
  void SendPicture();
  void OpenFetched(const QString& folder, const std::shared_ptr<const PrivateFolder>& temporary);

  /// True for a scan that was fetched from an archive, and is deleted at the end.
  bool IsTemporary(const std::string& path) const;
  void ShowStudies();
  void ShowTags();
  void MakeEditMenu();
  void MakeViewMenu();
  void MakeToolMenu();
  void MakeLeftButtonActions(QMenu* menu);
  void MakeAnnotationActions(QMenu* menu, QActionGroup* group);
  QAction* MakeToolAction(const MenuTool& tool, QMenu* menu, QActionGroup* group);
  void MakeComparisonActions(QMenu* menu);
  void MakeHelpMenu();
  void MakeLanguageMenu(QMenu* menu);
  void MakePanels();
  void MakePanelTabs();
  void ArrangeToolBars();
  void MakeCurvedView();
  QWidget* WithKeyImages(QWidget* measures);
  void MarkKeyImage();
  void ArrangePanels();
  void MakePanelMenu();
  void MakeStatusBar();
  static QString FileFilter();
  void MakeAskAtStartAction(QMenu* menu);
  void MakeMemoryMenu(QMenu* menu);
  void MakeOpenActions(QMenu* menu);
  void FillKinds(QMenu* kinds);
  void ChooseFile();
  void ChooseTimes();
  void ChooseFolder();
  void ChooseRawFile();
  void ChooseSegmentation();
  bool SaveSegmentation(int volume); ///< false if the user cancels, or if saving fails
  QWidget* MakeSegmentsPanel();
  void ChooseFurtherScan();
  void TakeSuggestedLook();
  void Register(int overlay);
  void TakeRegistered(int overlay, const Placement& placement);
  void ShowAdded(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  bool SaveSession(); ///< false if the user cancels, or if saving fails

  /// The user's work on the volume, see WorkText; empty without a volume.
  QString CurrentWork() const;

  /// Segments that were restored from the autosaved copy, which goes, are in no file.
  void ForgetAutosavedFile(Scene& scene) const;

  /// Returns true if the shown scan can be left: its work is saved, or the user gives it up.
  bool MayLeaveScan();
  void RenewGraphics();
  void ShowSaved(const QString& path);
  void ListRecentScans();
  void ShowAbout();
  void OpenSample(const VolumeSource& sample);
  void ShowTour();
  std::vector<TourStep> TourSteps();
  void ForgetRequest();
  void BeginLoading(const QString& path);
  void Load(const VolumeSource& source, const QString& series = {},
    const std::optional<SceneLabels>& labels = {},
    const std::vector<OverlaidVolume>& overlays = {});
  void OpenSegmentation(const SceneLabels& labels);
  void ReadSegmentation(const SceneLabels& labels, int volume);
  void OpenDropped(const QString& path);
  void ShowSegmentation(const SceneLabels& labels, const std::shared_ptr<const Study>& labelled);
  void RaiseSegments();
  void AskForSegmentation(const SceneLabels& labels, const std::shared_ptr<const Study>& labelled,
    const std::shared_ptr<const Study>& own);
  void OfferSegmentations(const FileSource& folder);
  void ShowOffered(const FileSource& folder, const std::vector<SeriesSummary>& offered);
  void ExportPicture();
  /// Words of a movie's dialogs.
  struct MovieTexts
  {
    QString title;
    QString waiting;
    QString name; ///< suggested file name
  };

  /// Asks for a file and lets a function write it, while a dialog shows its progress.
  void ExportMovie(const MovieTexts& texts,
    const std::function<bool(const QString&, const std::function<bool(double)>&)>& write);
  void MakeExportActions(QMenu* file);
  void ExportTurntable();
  void ExportTimes();
  /// Shows a stage of a change, by the part of it that is done, [0, 1].
  using SceneStage = std::function<void(PictureMaker&, const Study&, double)>;

  void MakeChangeActions(QMenu* file);
  void ExportChange(const MovieTexts& texts, const SceneStage& show);
  void ExportCuts();
  void ExportLookChange(const std::string& preset);
  void ListLooksToChange(QMenu* menu);
  void ExportReport();
  void ShowBenchmark();
  void AskForLayout(const QString& path);
  void AskForSeries(const FileSource& source, const std::vector<SeriesSummary>& series);
  void ShowLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  void ShowPreview(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  bool TakeLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  void KeepInMind(const FileSource& file, const Study& study);
  void ShowSuggestion(const Study& study);
  void ShowWarnings(bool isNewVolume);
  void TakeRemedy();
  void ArrangeSingleImage();
  void LookForSeries(const VolumeSource& source);
  void ToggleRectified();
  void Exchange(const VolumeSource& source, const std::shared_ptr<const Study>& form);
  void ShowFailure(const QString& reason);
  void ShowLoading(bool loading);

  SceneModel model;
  VolumeLoader loader;
  Autosave autosave;
  RecentScans recentScans;
  std::optional<Scene> restored;  ///< scene whose volume is being loaded
  bool exchanges = false;         ///< true while another form of the shown volume is being loaded
  bool restoresAutosaved = false; ///< the scene being loaded is the autosaved one
  bool addsScan = false;          ///< true while a further scan is being loaded
  bool isDropped = false;         ///< the file being loaded may be a segmentation of the scan
  bool isSingleImage = false;     ///< the scan that is shown is a single image
  bool isPreviewed = false;       ///< a coarse copy of the volume being loaded was shown
  int labelledVolume = 0;         ///< the volume that a segmentation is being loaded for
  std::vector<SeriesSummary> segmentations; ///< found in the folder that is being loaded
  std::vector<std::shared_ptr<const PrivateFolder>> fetched; ///< scans of archives, until the end
  QString savedWork;                                         ///< the work that is in a file
  int resetsInARow = 0; ///< resets of the graphics card without an image between them
  ComparisonView* view;
  std::vector<SliceView*> sliceViews;
  SegmentEditor* segmentEditor;
  ViewLayout* views;
  StartPage* startPage;
  TimeSeries* times;
  TimeBar* timeBar;
  TimeCurve* timeCurve;
  WarningBar* warnings;
  BackgroundTask seriesSearch;            ///< looks for the other images of a single one
  std::optional<WholeSeries> wholeSeries; ///< belongs to the single image shown
  QMenu* recentMenu;
  ViewMenu* viewMenu;
  std::vector<QDockWidget*> panels;
  KeyImagesBox* keyImages;
  KeyView lastView = KeyView::Volume; ///< clicked last, or had the keys
  QDockWidget* curvedDock;            ///< holds the view along a curve
  QProgressBar* progress;
  QPushButton* cancel;
};

}

#endif
