// The part of MainWindow that sets up the tools: actions of the left button, and comparisons.

#include "Viewer/MainWindow.h"

#include "Viewer/PanelTabs.h"
#include "Viewer/Panels/KeyImagesBox.h"
#include "Viewer/Tools/ToolIcons.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"
#include "Viewer/View/VolumeView.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace varimarch
{

/// A tool of the left button in the menu.
struct MainWindow::MenuTool
{
  LeftButton button;
  QString name;
  const char* key;
  QString tip;
};

void MainWindow::MakeToolMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&Tools"));
  this->MakeLeftButtonActions(menu);
  menu->addSeparator();
  menu->addAction(tr("&Mark a key image"), this, &MainWindow::MarkKeyImage, QKeySequence("Ctrl+M"))
    ->setObjectName("markKeyImage");
  this->view->Ours()->installEventFilter(this);
  for (SliceView* const slice : this->sliceViews)
  {
    slice->installEventFilter(this);
  }
  menu->addSeparator();
  this->MakeComparisonActions(menu);
}

// The menu holds the shortcuts; a tool bar makes the tools visible.
void MainWindow::MakeLeftButtonActions(QMenu* menu)
{
  const MenuTool tools[] = {
    { LeftButton::Turn, tr("&Rotate"), "T", tr("Drag to rotate the volume") },
    { LeftButton::Walk, tr("Wa&lk"), "G",
      tr("Walk through the volume: W, A, S, D or arrow keys, E and Q; drag to look around") },
    { LeftButton::Brightness, tr("&Window/Level"), "W",
      tr("Drag sideways for the window, up and down for the level; or drag with Ctrl") },
    { LeftButton::Distance, tr("&Distance"), "M", tr("Drag from one point to another") },
    { LeftButton::Angle, tr("&Angle"), "A",
      tr("Drag from the end of one arm to the vertex, then press at the end of the other") },
    { LeftButton::Box, tr("B&ox"), "B", tr("Drag from corner to corner: mean, deviation, volume") },
    { LeftButton::CutOut, tr("&Scissors"), "X", tr("Draw around the part to remove") },
    { LeftButton::KeepOnly, tr("&Keep inside"), "Shift+X", tr("Draw around the part to keep") },
  };
  auto* const bar = this->addToolBar(tr("Tool bar"));
  bar->setObjectName("leftButton");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const int side = this->fontMetrics().height();
  bar->setIconSize({ side, side });
  auto* const group = new QActionGroup(this);
  for (const MenuTool& tool : tools)
  {
    bar->addAction(this->MakeToolAction(tool, menu, group));
  }
  auto* const more = new QToolButton;
  more->setObjectName("annotate");
  more->setText(tr("Annotate"));
  more->setIcon(AnnotationIcon());
  more->setToolTip(tr("Cobb angles, regions, curves, arrows and texts"));
  more->setPopupMode(QToolButton::InstantPopup);
  QMenu* const annotations = menu->addMenu(tr("Anno&tate"));
  this->MakeAnnotationActions(annotations, group);
  more->setMenu(annotations);
  bar->addWidget(more);
  // Qt tells only the buttons of actions of the style of the bar.
  more->setToolButtonStyle(bar->toolButtonStyle());
  more->setIconSize(bar->iconSize());
  connect(bar, &QToolBar::toolButtonStyleChanged, more, &QToolButton::setToolButtonStyle);
}

void MainWindow::MakeAnnotationActions(QMenu* menu, QActionGroup* group)
{
  const MenuTool tools[] = {
    { LeftButton::CobbAngle, tr("&Cobb angle"), "Shift+A",
      tr("Drag along one line, then another") },
    { LeftButton::Ellipse, tr("&Ellipse"), "O",
      tr("Drag across a slice: area, mean, deviation, smallest and largest value") },
    { LeftButton::Freehand, tr("&Freehand region"), "Shift+O",
      tr("Draw around a region of a slice: area, mean, deviation, smallest and largest value") },
    { LeftButton::Curve, tr("C&urve"), "U",
      tr("Click along a vessel or the jaw: its length, and the volume straightened along it") },
    { LeftButton::Arrow, tr("&Arrow"), "Shift+M", tr("Drag to the thing to show, then type") },
    { LeftButton::Text, tr("&Text"), "Shift+T", tr("Click, then type") },
  };
  for (const MenuTool& tool : tools)
  {
    this->MakeToolAction(tool, menu, group);
  }
}

QAction* MainWindow::MakeToolAction(const MenuTool& tool, QMenu* menu, QActionGroup* group)
{
  QAction* const action = group->addAction(menu->addAction(tool.name));
  action->setIcon(IconOf(tool.button));
  action->setIconVisibleInMenu(false); // menus show which tool is chosen there
  action->setCheckable(true);
  action->setChecked(tool.button == LeftButton::Turn);
  action->setShortcut(QKeySequence(tool.key));
  action->setToolTip(tr("%1 (%2)").arg(tool.tip, action->shortcut().toString()));
  action->setStatusTip(tool.tip);
  connect(action, &QAction::triggered, this,
    [this, button = tool.button]
    {
      this->view->SetTool(button);
      for (SliceView* slice : this->sliceViews)
      {
        slice->SetTool(button);
      }
    });
  return action;
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

void MainWindow::resizeEvent(QResizeEvent* event)
{
  QMainWindow::resizeEvent(event);
  this->ArrangeToolBars();
}

void MainWindow::MarkKeyImage()
{
  this->keyImages->Mark(this->lastView);
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

void MainWindow::MakeComparisonActions(QMenu* menu)
{
  auto* const comparisons = new QActionGroup(this);
  const std::tuple<QString, std::optional<MapperKind>> kinds[] = {
    { tr("&No comparison"), std::nullopt },
    { tr("Compare with VTK's &GPU mapper"), MapperKind::VtkGpu },
    { tr("Compare with VTK's CP&U mapper"), MapperKind::VtkCpu },
  };
  for (const auto& [name, kind] : kinds)
  {
    QAction* const action = comparisons->addAction(menu->addAction(name));
    action->setCheckable(true);
    action->setChecked(!kind);
    connect(action, &QAction::triggered, this, [this, kind = kind] { this->Compare(kind); });
  }
  QAction* const wipe = menu->addAction(tr("W&ipe between them"));
  wipe->setCheckable(true);
  wipe->setStatusTip(tr("Both images in one place, with a divider to drag"));
  connect(wipe, &QAction::toggled, this->view, &ComparisonView::SetWipe);
  menu->addAction(tr("Benc&hmark…"), this, &MainWindow::ShowBenchmark)->setObjectName("benchmark");
}

void MainWindow::Compare(std::optional<MapperKind> kind)
{
  this->view->CompareWith(kind);
  this->views->ShowSlices(!kind); // three images side by side need their room
}

}
