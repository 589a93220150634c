#include "Viewer/MainWindow.h"

#include "Scene/Looks/Presets.h"
#include "Scene/Slices/SlicePicture.h"
#include "Viewer/AccessibleNames.h"
#include "Viewer/ExportActions.h"
#include "Viewer/HelpActions.h"
#include "Viewer/Menus.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/SegmentEditor.h"
#include "Viewer/Model/TimeSeries.h"
#include "Viewer/Open/StartPage.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/PanelTabs.h"
#include "Viewer/Panels/CutsPanel.h"
#include "Viewer/Panels/LightsPanel.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Panels/PresetGallery.h"
#include "Viewer/Panels/QualityPanel.h"
#include "Viewer/Panels/SegmentsPanel.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/Panels/VolumesPanel.h"
#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/SaveActions.h"
#include "Viewer/ScanLists.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/CurvedView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"
#include "Viewer/View/VolumeView.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace varimarch
{

namespace
{

QString DataFolder()
{
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
}

// Two widgets in a column, with the heights that they get of its room.
QWidget* InColumn(QWidget* upper, int upperStretch, QWidget* lower, int lowerStretch)
{
  auto* const both = new QWidget;
  auto* const column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(upper, upperStretch);
  column->addWidget(lower, lowerStretch);
  return both;
}

}

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , autosave(&this->model, DataFolder())
  , work(&this->model, &this->autosave)
  , loader({ &this->model, &this->work, [this] { return this->saving->MayLeaveScan(); } })
  , view(new ComparisonView(&this->model))
{
  this->setWindowTitle(tr("Varimarch, not for diagnostic use"));
  this->MakeActions();
  this->MakeCenter();
  this->setAcceptDrops(true);
  this->resize(1280, 800);
  this->MakeMenus();
  this->MakePanels();
  this->MakeStatusBar();
  const QSettings settings;
  this->restoreGeometry(settings.value("window/geometry").toByteArray());
  this->restoreState(settings.value("window/panels").toByteArray());
  this->curvedDock->hide(); // there is no curve yet
  this->Listen();
}

void MainWindow::MakeActions()
{
  this->lists = new ScanLists(&this->model, this);
  this->saving = new SaveActions({ &this->model, &this->work, this->lists }, this);
  this->opening = new OpenActions(
    { &this->model, &this->loader, this->saving, this->lists, &this->autosave }, this);
  connect(this->saving, &SaveActions::Saved, this, &MainWindow::ShowSaved);
  connect(this->opening, &OpenActions::Failed, this, &MainWindow::OpeningFailed);
}

void MainWindow::MakeCenter()
{
  auto* const center = new QWidget;
  auto* const column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* const warnings = new WarningBar(&this->model);
  connect(warnings, &WarningBar::SeriesWanted, this->opening, &OpenActions::Open);
  connect(warnings, &WarningBar::OtherFormWanted, this, &MainWindow::ToggleRectified);
  connect(&this->loader, &LoadController::Opened, warnings, &WarningBar::LookForSeries);
  column->addWidget(warnings);
  this->MakeViews();
  this->help = new HelpActions({ this->view, this->sliceViews.front() }, this);
  auto* const pages = new QStackedWidget;
  pages->addWidget(this->MakeStartPage());
  pages->addWidget(this->views);
  connect(&this->model, &SceneModel::Changed, pages,
    [this, pages]
    {
      if (pages->currentWidget() != this->views)
      {
        pages->setCurrentWidget(this->views);
        this->view->Ours()->setFocus();
      }
    });
  column->addWidget(pages, 1);
  this->MakeTimes(column);
  this->setCentralWidget(center);
}

void MainWindow::MakeViews()
{
  std::vector<QWidget*> slices;
  auto* const turns = new DrawingTurns(this);
  const std::pair<SlicePlane, QString> planes[] = { { SlicePlane::Axial, tr("Axial slice") },
    { SlicePlane::Coronal, tr("Coronal slice") }, { SlicePlane::Sagittal, tr("Sagittal slice") } };
  for (const auto& [plane, name] : planes)
  {
    this->sliceViews.push_back(new SliceView(&this->model, plane));
    this->sliceViews.back()->setAccessibleName(name);
    this->sliceViews.back()->SetTurns(turns);
    slices.push_back(this->sliceViews.back());
  }
  auto* const bars = new QWidget;
  auto* const column = new QVBoxLayout(bars);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new FusionBar(&this->model));
  column->addWidget(new SlabBar(&this->model));
  this->views = new ViewLayout(this->view, slices, bars);
  this->segmentEditor = new SegmentEditor(&this->model, this);
  this->view->Ours()->SetSegmentEditor(this->segmentEditor);
  connect(this->view->Ours(), &VolumeView::DoubleClicked, this->views,
    [this] { this->views->Toggle(this->view); });
  for (SliceView* const slice : this->sliceViews)
  {
    slice->SetSegmentEditor(this->segmentEditor);
    connect(
      slice, &SliceView::DoubleClicked, this->views, [this, slice] { this->views->Toggle(slice); });
  }
}

QWidget* MainWindow::MakeStartPage()
{
  auto* const page = new StartPage(this->lists->Recent());
  connect(page, &StartPage::FileWanted, this->opening, &OpenActions::ChooseFile);
  connect(page, &StartPage::FolderWanted, this->opening, &OpenActions::ChooseFolder);
  connect(page, &StartPage::ScanWanted, this->opening, &OpenActions::Open);
  connect(page, &StartPage::TourWanted, this->help, &HelpActions::ShowTour);
  connect(page, &StartPage::SampleWanted, this->opening, &OpenActions::OpenSample);
  return page;
}

void MainWindow::MakeTimes(QLayout* column)
{
  auto* const times = new TimeSeries(&this->model, this);
  this->timeBar = new TimeBar(&this->model, times);
  auto* const curve = new TimeCurve(&this->model, times);
  curve->hide();
  connect(this->timeBar, &TimeBar::CurveWanted, curve, &QWidget::setVisible);
  connect(times, &TimeSeries::Failed, this, &MainWindow::ShowMessage);
  column->addWidget(curve);
  column->addWidget(this->timeBar);
}

void MainWindow::MakeMenus()
{
  this->MakeFileMenu();
  this->MakeEditMenu();
  this->MakeViewMenu();
  this->MakeToolMenu();
  this->help->AddTo(this->menuBar()->addMenu(tr("&Help")));
}

void MainWindow::MakeFileMenu()
{
  QMenu* const file = this->menuBar()->addMenu(tr("&File"));
  this->opening->AddTo(file);
  this->lists->AddRecentScansTo(file);
  this->opening->AddSettingsTo(file);
  this->lists->AddListsTo(file);
  this->saving->AddTo(file);
  file->addSeparator();
  auto* const exports =
    new ExportActions({ &this->model, this->view->Ours(), this->timeBar }, this);
  connect(exports, &ExportActions::Saved, this, &MainWindow::ShowSaved);
  exports->AddTo(file);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);
}

void MainWindow::MakeEditMenu()
{
  QMenu* const edit = this->menuBar()->addMenu(tr("&Edit"));
  QAction* const undo = this->model.History()->createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* const redo = this->model.History()->createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence::Redo);
  edit->addActions({ undo, redo });
  for (const auto signal : { &SegmentEditor::StrokingChanged, &SegmentEditor::WorkingChanged })
  {
    connect(this->segmentEditor, signal, this,
      [this, undo, redo](bool isBusy)
      {
        undo->setEnabled(!isBusy && this->model.History()->canUndo());
        redo->setEnabled(!isBusy && this->model.History()->canRedo());
      });
  }
  edit->addSeparator();
  edit->addAction(tr("&Suggested look"), this, &MainWindow::ShowSuggestedLook, QKeySequence("R"));
}

void MainWindow::MakeViewMenu()
{
  this->viewMenu = new ViewMenu(&this->model, this->views, this);
  this->menuBar()->addMenu(this->viewMenu);
  for (SliceView* const slice : this->sliceViews)
  {
    slice->SetCornerTexts(this->viewMenu->ChosenCornerTexts());
    connect(this->viewMenu, &ViewMenu::CornerTextsChosen, slice, &SliceView::SetCornerTexts);
  }
  this->viewMenu->AddTimes(this->timeBar->Actions());
}

void MainWindow::MakeToolMenu()
{
  auto* const menu = new ToolMenu(this);
  this->menuBar()->addMenu(menu);
  connect(menu, &ToolMenu::ToolChosen, this->view, &ComparisonView::SetTool);
  connect(menu, &ToolMenu::ComparisonChosen, this, &MainWindow::Compare);
  connect(menu, &ToolMenu::WipeChosen, this->view, &ComparisonView::SetWipe);
  connect(menu, &ToolMenu::BenchmarkWanted, this, &MainWindow::ShowBenchmark);
  connect(menu, &ToolMenu::KeyImageWanted, this, [this] { this->keyImages->Mark(this->lastView); });
  this->view->Ours()->installEventFilter(this);
  for (SliceView* const slice : this->sliceViews)
  {
    connect(menu, &ToolMenu::ToolChosen, slice, &SliceView::SetTool);
    slice->installEventFilter(this);
  }
}

QDockWidget* MainWindow::AddPanel(const QString& name, const QString& title, QWidget* panel)
{
  // Panels scroll if the window is lower than they are.
  auto* const scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus); // it follows the control that has the keys
  scroll->setWidget(panel);
  auto* const dock = new QDockWidget(title);
  dock->setObjectName(name);
  dock->setWidget(scroll);
  this->panels.push_back(dock);
  return dock;
}

void MainWindow::MakePanels()
{
  this->AddPanel(
    "presets", tr("Presets"), new PresetGallery(&this->model, DataFolder() + "/presets"));
  this->AddPanel("look", tr("Look"), new LookPanel(&this->model));
  this->AddPanel("lights", tr("Lights"), new LightsPanel(&this->model));
  QDockWidget* const cuts = this->AddPanel("cuts", tr("Cut away"), new CutsPanel(&this->model));
  this->AddPanel("measures", tr("Measurements"), this->MakeMeasuresPanel());
  this->AddPanel("volumes", tr("Volumes"), this->MakeVolumesPanel());
  this->AddPanel("segments", tr("Segments"), this->MakeSegmentsPanel());
  this->AddPanel("quality", tr("Quality"), new QualityPanel(&this->model));
  // Handles are visible only while the panel of the cuts is open.
  connect(cuts, &QDockWidget::visibilityChanged, this->view->Ours(), &VolumeView::ShowCutHandles);
  this->MakeCurvedView();
  this->MakePanelTabs();
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->ArrangePanels();
  this->MakePanelMenu();
  NamePartsOfControls(this);
}

QWidget* MainWindow::MakeMeasuresPanel()
{
  auto* const measures = new MeasuresPanel(&this->model);
  connect(measures, &MeasuresPanel::Saved, this, &MainWindow::ShowSaved);
  this->keyImages = new KeyImagesBox(&this->model);
  return InColumn(measures, 3, this->keyImages, 1);
}

QWidget* MainWindow::MakeVolumesPanel()
{
  auto* const volumes = new VolumesPanel(&this->model);
  connect(volumes, &VolumesPanel::AddWanted, this->opening, &OpenActions::ChooseFurtherScan);
  connect(volumes, &VolumesPanel::Registered, this,
    [this] {
      this->ShowMessage(tr("Registered; compare the volumes in the slices before you trust it"));
    });
  return volumes;
}

QWidget* MainWindow::MakeSegmentsPanel()
{
  auto* const segments = new SegmentsPanel(&this->model);
  connect(segments, &SegmentsPanel::OpenWanted, this->opening, &OpenActions::ChooseSegmentation);
  connect(segments, &SegmentsPanel::Saved, this, &MainWindow::ShowSaved);
  connect(segments, &SegmentsPanel::Selected, this->segmentEditor, &SegmentEditor::SetSegment);
  auto* const box = new SegmentEditingBox(&this->model, this->segmentEditor);
  connect(box, &SegmentEditingBox::SaveWanted, this,
    [this] { this->saving->SaveSegmentation(this->model.EditedVolume()); });
  return InColumn(segments, 1, box, 0);
}

// The view along a curve lies below the others while there is a curve.
void MainWindow::MakeCurvedView()
{
  auto* const curved = new CurvedView(&this->model);
  connect(curved, &CurvedView::Pointed, this, &MainWindow::ShowMessage);
  this->curvedDock = new QDockWidget(tr("Along the curve"));
  this->curvedDock->setObjectName("curve");
  this->curvedDock->setWidget(curved);
  this->addDockWidget(Qt::BottomDockWidgetArea, this->curvedDock);
  this->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea); // panels keep their height
  connect(&this->model, &SceneModel::Changed, this,
    [this, curved, hadCurve = false](ScenePart part) mutable
    {
      if (part != ScenePart::Volume && part != ScenePart::Measures)
      {
        return;
      }
      const bool hasCurve = curved->Path();
      if (hasCurve != hadCurve)
      {
        this->curvedDock->setVisible(hasCurve);
      }
      hadCurve = hasCurve;
    });
}

// The stacked panels are all but the last one.
void MainWindow::MakePanelTabs()
{
  QToolBar* const bar = this->addToolBar(tr("Titles of panels"));
  bar->setObjectName("panelBar");
  bar->setMovable(false);
  bar->toggleViewAction()->setVisible(false); // without it, panels would have no titles to click
  auto* const room = new QWidget;
  room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(room);
  auto* const tabs = new PanelTabs({ this->panels.begin(), this->panels.end() - 1 });
  tabs->setAccessibleName(bar->windowTitle());
  bar->addWidget(tabs);
}

// Leaves the icons out if the tools do not fit with them, as with large letters, and puts the
// titles of panels below the tools if they do not fit beside them.
void MainWindow::ArrangeToolBars()
{
  auto* const tools = this->findChild<QToolBar*>("leftButton");
  auto* const titles = this->findChild<QToolBar*>("panelBar");
  tools->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  if (tools->sizeHint().width() > this->width())
  {
    tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
  }
  const bool isBeside =
    tools->sizeHint().width() + titles->sizeHint().width() <= this->width() || tools->isHidden();
  if (isBeside && this->toolBarBreak(titles))
  {
    this->removeToolBarBreak(titles);
  }
  else if (!isBeside && !this->toolBarBreak(titles))
  {
    this->insertToolBarBreak(titles);
  }
}

// Stacks all panels except the last, which lies below them. Each is stacked at once, since the
// window would grow for panels below each other.
void MainWindow::ArrangePanels()
{
  for (std::size_t i = 0; i < this->panels.size(); ++i)
  {
    QDockWidget* const panel = this->panels[i];
    panel->setFloating(false);
    if (i == 0 || i + 1 == this->panels.size())
    {
      this->addDockWidget(Qt::RightDockWidgetArea, panel);
    }
    else
    {
      this->tabifyDockWidget(this->panels[i - 1], panel);
    }
    panel->show();
  }
  QDockWidget* const first = this->panels.front();
  first->raise();
  this->resizeDocks({ first, this->panels.back() }, { 560, 130 }, Qt::Vertical);
  this->resizeDocks({ first }, { 380 }, Qt::Horizontal);
}

void MainWindow::MakePanelMenu()
{
  QMenu* const menu = this->viewMenu->Panels();
  for (const QDockWidget* const panel : this->panels)
  {
    menu->addAction(panel->toggleViewAction());
  }
  menu->addAction(this->curvedDock->toggleViewAction());
  auto* const toolBar = this->findChild<QToolBar*>("leftButton");
  menu->addAction(toolBar->toggleViewAction());
  menu->addSeparator();
  menu
    ->addAction(tr("&Reset layout"), this,
      [this, toolBar]
      {
        this->ArrangePanels();
        toolBar->show();
      })
    ->setObjectName("resetLayout");
}

void MainWindow::MakeStatusBar()
{
  auto* const progress = new QProgressBar;
  progress->setRange(0, 100);
  auto* const cancel = new QPushButton(tr("Cancel"));
  this->statusBar()->addPermanentWidget(progress);
  this->statusBar()->addPermanentWidget(cancel);
  const auto showLoading = [progress, cancel](bool isLoading)
  {
    progress->setVisible(isLoading);
    progress->setValue(0);
    cancel->setVisible(isLoading);
  };
  showLoading(false);
  this->ShowMessage(tr("Open a scan, or drop one here"));
  connect(this->view->Ours(), &VolumeView::Pointed, this, &MainWindow::ShowMessage);
  for (SliceView* const slice : this->sliceViews)
  {
    connect(slice, &SliceView::Pointed, this, &MainWindow::ShowMessage);
  }
  connect(cancel, &QPushButton::clicked, &this->loader, &LoadController::Cancel);
  connect(&this->loader, &LoadController::LoadingChanged, progress, showLoading);
  connect(&this->loader, &LoadController::Progress, progress,
    [progress](double part) { progress->setValue(int(100.0 * part)); });
}

void MainWindow::Listen()
{
  connect(&this->model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (part == ScenePart::Look)
      {
        this->statusBar()->clearMessage(); // it gives the reason for the first look
      }
    });
  // The view is still drawing when it tells.
  connect(this->view->Ours(), &VolumeView::GraphicsLost, this, &MainWindow::RenewGraphics,
    Qt::QueuedConnection);
  connect(this->view->Ours(), &VolumeView::Drawn, this, [this] { this->resetsInARow = 0; });
  connect(&this->loader, &LoadController::Opened, this, &MainWindow::ArrangeSingleImage);
  // The tour shows the phantom if there is no scan, and none is being loaded.
  connect(this->help, &HelpActions::TourBegins, this,
    [this]
    {
      if (!this->model.CurrentStudy() && !this->loader.IsLoading())
      {
        this->opening->OpenSample(SampleTorso());
      }
    });
}

void MainWindow::ShowNoticeOnce()
{
  this->help->ShowNoticeOnce();
}

void MainWindow::Compare(std::optional<MapperKind> kind)
{
  this->view->CompareWith(kind);
  this->views->ShowSlices(!kind); // three images side by side need their room
}

void MainWindow::ShowBenchmark()
{
  if (this->model.CurrentStudy())
  {
    auto* const dialog = new BenchmarkDialog(&this->model, this->view->Ours()->size(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  }
}

void MainWindow::ShowMessage(const QString& text)
{
  this->statusBar()->showMessage(text);
}

void MainWindow::ShowSaved(const QString& path)
{
  this->ShowMessage(tr("Saved %1").arg(path));
}

// Gives the edited volume its first look again.
void MainWindow::ShowSuggestedLook()
{
  const auto study = this->model.EditedStudy();
  const int edited = this->model.EditedVolume();
  if (edited > 0)
  {
    const VolumeSource& source = this->model.CurrentScene().overlays[edited - 1].source;
    this->model.SetLook(
      OverlayOf(source, study->volume, study->statistics).look, tr("suggested look"));
  }
  else if (study)
  {
    const std::string name = SuggestedPreset(study->volume, study->statistics).name;
    this->model.SetPreset(BuiltInPreset(name), tr("suggested look"));
  }
}

// Segments are read anew for the other grid, so they are saved before.
void MainWindow::ToggleRectified()
{
  if (!this->model.HasUnsavedLabels() || this->saving->SaveSegmentation(0))
  {
    this->loader.ToggleRectified();
  }
}

// A single image, such as a radiograph, fills the window. In 3D and from its edges it is a line.
void MainWindow::ArrangeSingleImage()
{
  const auto single = SingleImageOf(this->model.CurrentStudy()->volume.image);
  if (single)
  {
    this->views->ShowAlone(this->sliceViews[std::size_t(single->plane)]);
  }
  else if (this->isSingleImage)
  {
    this->views->ShowAlone(nullptr);
  }
  this->isSingleImage = bool(single);
}

// Makes new contexts: that of the window, with which the views share theirs, is lost too.
void MainWindow::RenewGraphics()
{
  constexpr int MostInARow = 2;
  constexpr int GestureMilliseconds = 50;
  if (QGuiApplication::mouseButtons() != Qt::NoButton)
  {
    // A window that is made anew would miss the end of the gesture.
    QTimer::singleShot(GestureMilliseconds, this, &MainWindow::RenewGraphics);
    return;
  }
  LogEvent("graphics card reset");
  const bool goesOn = ++this->resetsInARow < MostInARow;
  if (goesOn)
  {
    // A view drops its context when it leaves a window.
    QWidget* const center = this->takeCentralWidget();
    this->hide();
    this->destroy(true, false);
    this->setCentralWidget(center);
    center->show();
    this->show();
  }
  auto* const box = new QMessageBox(QMessageBox::Warning, tr("Graphics card"),
    goesOn ? tr("The graphics card was reset, and the image is drawn anew; nothing is lost.")
           : tr("The graphics card was reset again before it had drawn an image; save the session "
                "and start the program again, with another driver, or with "
                "LIBGL_ALWAYS_SOFTWARE=1 to draw without the card."),
    QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (!OpenActions::LocalFiles(*event->mimeData()).isEmpty())
  {
    event->acceptProposedAction();
  }
}

// The program that the file is dragged from waits for the end of this function.
void MainWindow::dropEvent(QDropEvent* event)
{
  const QStringList paths = OpenActions::LocalFiles(*event->mimeData());
  QTimer::singleShot(0, this, [this, paths] { this->opening->OpenDropped(paths); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->saving->MayLeaveScan())
  {
    event->ignore();
    return;
  }
  LogEvent("window closed");
  this->loader.Cancel();
  // Without a volume, the copy of an earlier run could not be restored, or has not been yet.
  if (this->model.CurrentStudy())
  {
    this->autosave.Remove();
  }
  this->lists->DeleteTemporaryScans(); // the program may end before its threads do
  QSettings settings;
  settings.setValue("window/geometry", this->saveGeometry());
  settings.setValue("window/panels", this->saveState());
  QMainWindow::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QMainWindow::resizeEvent(event);
  this->ArrangeToolBars();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::FocusIn)
  {
    const auto slice = std::find(this->sliceViews.begin(), this->sliceViews.end(), watched);
    // The views are in the order of the planes.
    this->lastView = slice == this->sliceViews.end()
      ? KeyView::Volume
      : KeyView(int(KeyView::Axial) + int(slice - this->sliceViews.begin()));
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::childEvent(QChildEvent* event)
{
  QMainWindow::childEvent(event);
  // Qt creates a tab bar when docks are stacked. Our panels have tabs in the tool bar.
  auto* const tabs = event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
  if (tabs)
  {
    HideTabsOfQt(tabs);
  }
}

}
