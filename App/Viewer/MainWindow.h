#ifndef Varimarch_Viewer_MainWindow_h
#define Varimarch_Viewer_MainWindow_h

#include "Viewer/Model/RecentScans.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Model/VolumeLoader.h"

#include <QMainWindow>

#include <optional>
#include <vector>

class QMenu;
class QProgressBar;
class QPushButton;
class QSplitter;

namespace varimarch
{

class ComparisonView;
class SliceView;
class WarningBar;

/// The window: menus, the views, the panels around them, and the loading of volumes. What it opens
/// and keeps stands in MainWindowFiles.cxx, its tools in MainWindowTools.cxx.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// Begins to load a file, a folder with a DICOM series, or a session that was saved.
  /// @param series  the digest of the one to open of several series; empty: the user is asked
  void Open(const QString& path, const QString& series = {});

  /// Offers what an earlier program, which did not come to its end, has left.
  void OfferAutosaved();

  /// Says that this is not for diagnostic use, once and for all.
  void ShowNoticeOnce();

  /// Shows VTK's picture beside ours; none: ours alone.
  void Compare(std::optional<MapperKind> kind);

  SceneModel* Model() { return &this->model; }
  VolumeLoader* Loader() { return &this->loader; }
  ComparisonView* CentralView() { return this->view; }

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void childEvent(QChildEvent* event) override;

private:
  QWidget* MakeViews();
  void MakeMenus();
  void MakeViewMenu();
  void MakeProjectionAction(QMenu* menu);
  void ChooseBackground();
  void MakeToolMenu();
  void MakeLeftButtonActions(QMenu* menu);
  void MakeComparisonActions(QMenu* menu);
  void MakeHelpMenu();
  void MakeLanguageMenu(QMenu* menu);
  void MakePanels();
  void MakeStatusBar();
  void ChooseFile();
  void ChooseFolder();
  void ChooseRawFile();
  void SaveSession();
  void ListRecentScans();
  void ShowAbout();
  void Load(const VolumeSource& source, const QString& series = {});
  void ExportPicture();
  void ExportTurntable();
  void ExportReport();
  void ShowBenchmark();
  void AskForLayout(const QString& path);
  void AskForSeries(const FileSource& source, const std::vector<SeriesSummary>& series);
  void ShowLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study);
  void ShowDoubts();
  void RectifyOrNot();
  void Exchange(const VolumeSource& source, const std::shared_ptr<const Study>& form);
  void ShowFailure(const QString& reason);
  void ShowLoading(bool loading);

  SceneModel model;
  VolumeLoader loader;
  Autosave autosave;
  RecentScans recentScans;
  std::optional<Scene> restored; ///< the scene whose volume is being loaded
  bool exchanges = false;        ///< whether another form of what is shown is being loaded
  ComparisonView* view;
  QWidget* sliceColumn;
  QSplitter* slices;
  std::vector<SliceView*> sliceViews;
  WarningBar* warnings;
  QMenu* recentMenu;
  QProgressBar* progress;
  QPushButton* cancel;
};

}

#endif
