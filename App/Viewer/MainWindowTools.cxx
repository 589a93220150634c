// The part of MainWindow that sets up the tools: actions of the left button, and comparisons.

#include "Viewer/MainWindow.h"

#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"
#include "Viewer/View/VolumeView.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace varimarch
{

void MainWindow::MakeToolMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&Tools"));
  this->MakeLeftButtonActions(menu);
  menu->addSeparator();
  this->MakeComparisonActions(menu);
}

// The menu holds the shortcuts; a tool bar makes the tools visible.
void MainWindow::MakeLeftButtonActions(QMenu* menu)
{
  const std::tuple<LeftButton, QString, QString, QString> tools[] = {
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
  auto* const group = new QActionGroup(this);
  for (const auto& [tool, name, key, tip] : tools)
  {
    QAction* const action = group->addAction(menu->addAction(name));
    action->setCheckable(true);
    action->setChecked(tool == LeftButton::Turn);
    action->setShortcut(QKeySequence(key));
    action->setToolTip(tr("%1 (%2)").arg(tip, action->shortcut().toString()));
    action->setStatusTip(tip);
    bar->addAction(action);
    connect(action, &QAction::triggered, this,
      [this, tool = tool]
      {
        this->view->SetTool(tool);
        for (SliceView* slice : this->sliceViews)
        {
          slice->SetTool(tool);
        }
      });
  }
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
