#include "Viewer/MainWindow.h"

#include "Viewer/AccessibleNames.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/SegmentEditor.h"
#include "Viewer/Model/TimeSeries.h"
#include "Viewer/Open/StartPage.h"
#include "Viewer/Open/WarningBar.h"
#include "Viewer/PanelTabs.h"
#include "Viewer/Panels/CutsPanel.h"
#include "Viewer/Panels/FusionBar.h"
#include "Viewer/Panels/LightsPanel.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Panels/PresetGallery.h"
#include "Viewer/Panels/QualityPanel.h"
#include "Viewer/Panels/SlabBar.h"
#include "Viewer/Panels/TimeBar.h"
#include "Viewer/Panels/TimeCurve.h"
#include "Viewer/Panels/VolumesPanel.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/CurvedView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"
#include "Viewer/View/VolumeView.h"
#include "Viewer/ViewMenu.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <utility>

namespace varimarch
{

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , autosave(&this->model, QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
  , view(new ComparisonView(&this->model))
  , warnings(new WarningBar)
{
  this->setWindowTitle(tr("Varimarch, not for diagnostic use"));
  auto* const center = new QWidget;
  auto* const column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(this->warnings);
  this->MakeViews();
  this->MakeStartPage();
  this->MakeTimes();
  auto* const pages = new QStackedWidget;
  pages->addWidget(this->startPage);
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
  column->addWidget(this->timeCurve);
  column->addWidget(this->timeBar);
  this->setCentralWidget(center);
  this->setAcceptDrops(true);
  this->resize(1280, 800);
  this->MakeFileMenu();
  this->MakeEditMenu();
  this->MakeViewMenu();
  this->MakeToolMenu();
  this->MakeHelpMenu();
  this->MakePanels();
  this->MakeStatusBar();
  const QSettings settings;
  this->restoreGeometry(settings.value("window/geometry").toByteArray());
  this->restoreState(settings.value("window/panels").toByteArray());
  this->curvedDock->hide(); // there is no curve yet
  this->Listen();
}

void MainWindow::Listen()
{
  connect(this->warnings, &WarningBar::RemedyWanted, this, &MainWindow::TakeRemedy);
  connect(&this->model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (part == ScenePart::Volume || part == ScenePart::Labels || part == ScenePart::Overlays)
      {
        this->ShowWarnings(part == ScenePart::Volume);
      }
      if (part == ScenePart::Look)
      {
        this->statusBar()->clearMessage(); // it gives the reason for the first look
      }
    });
  // The view is still drawing when it tells.
  connect(this->view->Ours(), &VolumeView::GraphicsLost, this, &MainWindow::RenewGraphics,
    Qt::QueuedConnection);
  connect(this->view->Ours(), &VolumeView::Drawn, this, [this] { this->resetsInARow = 0; });
  connect(&this->loader, &VolumeLoader::Loaded, this, &MainWindow::ShowLoaded);
  connect(&this->loader, &VolumeLoader::Previewed, this, &MainWindow::ShowPreview);
  connect(&this->loader, &VolumeLoader::SeriesFound, this, &MainWindow::AskForSeries);
  connect(&this->loader, &VolumeLoader::LabelsLoaded, this, &MainWindow::ShowSegmentation);
  connect(
    &this->loader, &VolumeLoader::PossibleLabelsLoaded, this, &MainWindow::AskForSegmentation);
  connect(&this->loader, &VolumeLoader::SegmentationsFound, this,
    [this](const std::vector<SeriesSummary>& found) { this->segmentations = found; });
  connect(&this->loader, &VolumeLoader::Failed, this, &MainWindow::ShowFailure);
  connect(&this->loader, &VolumeLoader::Cancelled, this,
    [this]
    {
      LogEvent("loading cancelled");
      this->ShowLoading(false);
      this->statusBar()->showMessage(tr("Loading was cancelled"));
    });
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

void MainWindow::MakeStartPage()
{
  this->startPage = new StartPage(this->recentScans);
  connect(this->startPage, &StartPage::FileWanted, this, &MainWindow::ChooseFile);
  connect(this->startPage, &StartPage::FolderWanted, this, &MainWindow::ChooseFolder);
  connect(this->startPage, &StartPage::ScanWanted, this, &MainWindow::Open);
  connect(this->startPage, &StartPage::TourWanted, this, &MainWindow::ShowTour);
  connect(this->startPage, &StartPage::SampleWanted, this, &MainWindow::OpenSample);
}

void MainWindow::MakeTimes()
{
  this->times = new TimeSeries(&this->model, this);
  this->timeBar = new TimeBar(&this->model, this->times);
  this->timeCurve = new TimeCurve(&this->model, this->times);
  this->timeCurve->hide();
  connect(this->timeBar, &TimeBar::CurveWanted, this->timeCurve, &QWidget::setVisible);
  connect(this->times, &TimeSeries::Failed, this,
    [this](const QString& reason) { this->statusBar()->showMessage(reason); });
}

void MainWindow::MakeFileMenu()
{
  QMenu* const file = this->menuBar()->addMenu(tr("&File"));
  this->MakeOpenActions(file);
  QAction* const further =
    file->addAction(tr("A&dd a scan…"), this, &MainWindow::ChooseFurtherScan);
  further->setObjectName("addScan");
  further->setEnabled(false);
  connect(&this->model, &SceneModel::Changed, further, [further] { further->setEnabled(true); });
  QAction* const segmentation =
    file->addAction(tr("Open a se&gmentation…"), this, &MainWindow::ChooseSegmentation);
  segmentation->setObjectName("openSegmentation");
  segmentation->setEnabled(false);
  connect(&this->model, &SceneModel::Changed, segmentation,
    [segmentation] { segmentation->setEnabled(true); });
  this->recentMenu = file->addMenu(tr("&Recent scans"));
  this->recentMenu->setObjectName("recent");
  connect(this->recentMenu, &QMenu::aboutToShow, this, &MainWindow::ListRecentScans);
  this->MakeAskAtStartAction(file);
  this->MakeMemoryMenu(file->addMenu(tr("Memor&y for volumes")));
  this->MakeArchiveActions(file);
  file->addAction(tr("&Save the session…"), this, &MainWindow::SaveSession, QKeySequence::Save);
  file->addSeparator();
  this->MakeExportActions(file);
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
  edit->addAction(tr("&Suggested look"), this, &MainWindow::TakeSuggestedLook, QKeySequence("R"));
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

void MainWindow::MakePanels()
{
  const auto dockOf = [this](const QString& name, const QString& title, QWidget* panel)
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
  };
  dockOf("presets", tr("Presets"),
    new PresetGallery(&this->model,
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/presets"));
  dockOf("look", tr("Look"), new LookPanel(&this->model));
  dockOf("lights", tr("Lights"), new LightsPanel(&this->model));
  QDockWidget* const cuts = dockOf("cuts", tr("Cut away"), new CutsPanel(&this->model));
  auto* const measures = new MeasuresPanel(&this->model);
  connect(measures, &MeasuresPanel::Saved, this, &MainWindow::ShowSaved);
  dockOf("measures", tr("Measurements"), this->WithKeyImages(measures));
  auto* const volumes = new VolumesPanel(&this->model);
  connect(volumes, &VolumesPanel::AddWanted, this, &MainWindow::ChooseFurtherScan);
  connect(volumes, &VolumesPanel::RegistrationWanted, this, &MainWindow::Register);
  dockOf("volumes", tr("Volumes"), volumes);
  dockOf("segments", tr("Segments"), this->MakeSegmentsPanel());
  dockOf("quality", tr("Quality"), new QualityPanel(&this->model));
  // Handles are visible only while the panel of the cuts is open.
  connect(cuts, &QDockWidget::visibilityChanged, this->view->Ours(), &VolumeView::ShowCutHandles);
  this->MakeCurvedView();
  this->MakePanelTabs();
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->ArrangePanels();
  this->MakePanelMenu();
  NamePartsOfControls(this);
}

// The view along a curve lies below the others while there is a curve.
void MainWindow::MakeCurvedView()
{
  auto* const curved = new CurvedView(&this->model);
  connect(curved, &CurvedView::Pointed, this,
    [this](const QString& text) { this->statusBar()->showMessage(text); });
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
  this->progress = new QProgressBar;
  this->progress->setRange(0, 100);
  this->cancel = new QPushButton(tr("Cancel"));
  this->statusBar()->addPermanentWidget(this->progress);
  this->statusBar()->addPermanentWidget(this->cancel);
  this->ShowLoading(false);
  this->statusBar()->showMessage(tr("Open a scan, or drop one here"));
  const auto showText = [this](const QString& text) { this->statusBar()->showMessage(text); };
  connect(this->view->Ours(), &VolumeView::Pointed, this->statusBar(), showText);
  for (SliceView* const slice : this->sliceViews)
  {
    connect(slice, &SliceView::Pointed, this->statusBar(), showText);
  }
  connect(this->cancel, &QPushButton::clicked, &this->loader, &VolumeLoader::Cancel);
  connect(&this->loader, &VolumeLoader::Progress, this->progress,
    [this](double part) { this->progress->setValue(int(100.0 * part)); });
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
