#ifndef Varimarch_Viewer_MainWindow_h
#define Varimarch_Viewer_MainWindow_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Open/LoadController.h"
#include "Viewer/OpenActions.h"

#include <QMainWindow>

#include <optional>
#include <vector>

class QDockWidget;

namespace varimarch
{

class ComparisonView;
class HelpActions;
class KeyImagesBox;
class SaveActions;
class ScanLists;
class SegmentEditor;
class SliceView;
class TimeBar;
class ViewLayout;
class ViewMenu;

/// The main window: views, panels and menus around a model. It puts the parts together, which do
/// the work: LoadController loads, OpenActions asks what to open, SaveActions saves, ExportActions
/// writes images and movies.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// These start to load as OpenActions does.
  void Open(const QString& path, const QString& series = {}) { this->opening->Open(path, series); }
  void OpenTogether(const QStringList& paths) { this->opening->OpenTogether(paths); }
  void OpenTimes(const QString& path) { this->opening->OpenTimes(path); }
  void AddScan(const QString& path) { this->opening->AddScan(path); }
  void OfferAutosaved() { this->opening->OfferAutosaved(); }
  void OfferFileAtStart() { this->opening->OfferFileAtStart(); }

  /// Shows, once per user, the notice that the program is not for diagnostic use.
  void ShowNoticeOnce();

  /// Shows VTK's image beside ours; std::nullopt shows only ours.
  void Compare(std::optional<MapperKind> kind);

  SceneModel* Model() { return &this->model; }
  LoadController* Loader() { return &this->loader; }
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
  void MakeActions();
  void MakeCenter();
  void MakeViews();
  QWidget* MakeStartPage();
  void MakeTimes(QLayout* column);
  void MakeMenus();
  void MakeFileMenu();
  void MakeEditMenu();
  void MakeViewMenu();
  void MakeToolMenu();
  void MakePanels();
  QDockWidget* AddPanel(const QString& name, const QString& title, QWidget* panel);
  QWidget* MakeVolumesPanel();
  QWidget* MakeMeasuresPanel();
  QWidget* MakeSegmentsPanel();
  void MakeCurvedView();
  void MakePanelTabs();
  void ArrangePanels();
  void ArrangeToolBars();
  void MakePanelMenu();
  void MakeStatusBar();
  void Listen();
  void ShowBenchmark();
  void ShowMessage(const QString& text);
  void ShowSaved(const QString& path);
  void ShowSuggestedLook();
  void ToggleRectified();
  void ArrangeSingleImage();
  void RenewGraphics();

  SceneModel model;
  Autosave autosave;
  SavedWork work;
  LoadController loader;
  ScanLists* lists;
  SaveActions* saving;
  OpenActions* opening;
  HelpActions* help;
  ComparisonView* view;
  std::vector<SliceView*> sliceViews;
  SegmentEditor* segmentEditor;
  ViewLayout* views;
  TimeBar* timeBar;
  ViewMenu* viewMenu;
  std::vector<QDockWidget*> panels;
  QDockWidget* curvedDock; ///< holds the view along a curve
  KeyImagesBox* keyImages;
  KeyView lastView = KeyView::Volume; ///< clicked last, or had the keys
  bool isSingleImage = false;         ///< the scan that is shown is a single image
  int resetsInARow = 0;               ///< resets of the graphics card without an image between them
};

}

#endif
