// Keyboard commands and menus of the editor of regions. They cover everything that the mouse can
// do.

#include "Scene/LookRegions.h"
#include "Viewer/EditorActions.h"
#include "Viewer/LiveColorDialog.h"
#include "Viewer/Model/Gesture.h"
#include "Viewer/RegionEditor/RegionEditor.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QAction>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

namespace varimarch
{

namespace
{

constexpr double NudgePart = 0.005; // share of the visible part of the plane
constexpr double LargeNudgeFactor = 10.0;

}

void RegionEditor::MakeActions()
{
  QAction* const rectangle = AddKeyAction(this, tr("Add a rectangle"), Qt::Key_Insert);
  rectangle->setIconText(tr("+ Rectangle"));
  connect(rectangle, &QAction::triggered, this,
    [this] { this->Add(RegionShape::Rectangle, this->picture.layout.plot.center()); });
  QAction* const ellipse =
    AddKeyAction(this, tr("Add an ellipse"), QKeySequence(Qt::SHIFT | Qt::Key_Insert));
  ellipse->setIconText(tr("+ Ellipse"));
  connect(ellipse, &QAction::triggered, this,
    [this] { this->Add(RegionShape::Ellipse, this->picture.layout.plot.center()); });
  QAction* const color = AddKeyAction(this, tr("Colour…"), Qt::Key_C);
  connect(color, &QAction::triggered, this, &RegionEditor::ChooseColor);
  QAction* const remove = AddKeyAction(this, tr("Delete"), Qt::Key_Delete);
  connect(remove, &QAction::triggered, this, &RegionEditor::DeleteSelected);
  QAction* const all = AddKeyAction(this, tr("Show all values and gradients"), Qt::Key_F);
  all->setIconText(tr("All"));
  connect(all, &QAction::triggered, this, &RegionEditor::ShowAll);
  this->editActions = { rectangle, ellipse, color, remove, all };
  const auto update = [this, color, remove, rectangle, ellipse]
  {
    color->setEnabled(this->Selected() != nullptr);
    remove->setEnabled(this->Selected() != nullptr);
    const bool hasRoom = this->picture.regions.size() < MostRegions;
    rectangle->setEnabled(hasRoom);
    ellipse->setEnabled(hasRoom);
  };
  connect(this, &RegionEditor::SelectionChanged, this, update);
  update();
}

void RegionEditor::Add(RegionShape shape, const QPointF& position)
{
  const RegionLayout& layout = this->picture.layout;
  std::vector<LookRegion> regions = this->picture.regions;
  regions.push_back(NewRegion(shape, layout.ToValue(position.x()), layout.ToGradient(position.y()),
    { layout.values.Last() - layout.values.First(),
      layout.gradients.Last() - layout.gradients.First() },
    this->Plane()));
  this->Edit(regions, tr("add a region"), NewGesture());
  this->Select(int(regions.size()) - 1);
}

void RegionEditor::DeleteSelected()
{
  if (!this->Selected())
  {
    return;
  }
  std::vector<LookRegion> regions = this->picture.regions;
  regions.erase(regions.begin() + this->picture.selected);
  this->drag = Drag::None;
  this->Select(-1);
  this->Edit(regions, tr("delete a region"), NewGesture());
}

void RegionEditor::ChooseColor()
{
  if (!this->Selected())
  {
    return;
  }
  const std::vector<LookRegion> before = this->picture.regions;
  const int index = this->picture.selected;
  const QString name = tr("colour of a region");
  const auto edit = [=, chosenGesture = NewGesture()](const glm::dvec3& rgb)
  {
    std::vector<LookRegion> regions = before;
    regions[std::size_t(index)].rgb = rgb;
    this->Edit(regions, name, chosenGesture);
  };
  const glm::dvec3 old = before[std::size_t(index)].rgb;
  const QColorDialog* const dialog = OpenLiveColorDialog(
    QColorOf(old),
    [edit](const QColor& chosen) {
      edit({ chosen.redF(), chosen.greenF(), chosen.blueF() });
    },
    this);
  connect(dialog, &QDialog::rejected, this, [edit, old] { edit(old); });
}

bool RegionEditor::event(QEvent* event)
{
  // While the editor has the focus, its keys override the window's shortcuts.
  if (event->type() == QEvent::ShortcutOverride)
  {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (IsArrowKey(key.key()) || ActionOfKey(*this, key) ||
      (key.key() == Qt::Key_Escape && this->drag != Drag::None))
    {
      event->accept();
    }
  }
  return QWidget::event(event);
}

void RegionEditor::keyPressEvent(QKeyEvent* event)
{
  const bool zooms = event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus;
  if (QAction* const action = ActionOfKey(*this, *event))
  {
    action->trigger();
  }
  else if (IsArrowKey(event->key()))
  {
    this->Nudge(*event);
  }
  else if (zooms)
  {
    this->Zoom(this->picture.layout.plot.center(),
      event->key() == Qt::Key_Plus ? ZoomPerKey : 1.0 / ZoomPerKey);
  }
  else if (event->key() == Qt::Key_Escape && this->drag != Drag::None)
  {
    this->CancelDrag();
  }
  else
  {
    QWidget::keyPressEvent(event);
  }
}

// Arrows move the selected region; with Ctrl they move its right or upper side, and with Shift ten
// times as far.
void RegionEditor::Nudge(const QKeyEvent& event)
{
  if (!this->Selected())
  {
    this->Select(this->picture.regions.empty() ? -1 : 0);
    return;
  }
  this->gesture = event.isAutoRepeat() ? this->gesture : NewGesture();
  const int key = event.key();
  const double size =
    NudgePart * (event.modifiers().testFlag(Qt::ShiftModifier) ? LargeNudgeFactor : 1.0);
  const double right = key == Qt::Key_Right ? size : key == Qt::Key_Left ? -size : 0.0;
  const double up = key == Qt::Key_Up ? size : key == Qt::Key_Down ? -size : 0.0;
  const bool resizes = event.modifiers().testFlag(Qt::ControlModifier);
  const RegionHandle moved =
    resizes ? RegionHandle{ right != 0.0 ? 1 : 0, up != 0.0 ? 1 : 0 } : RegionHandle();
  const RegionLayout& layout = this->picture.layout;
  this->EditSelected(
    resizes ? tr("resize a region") : tr("move a region"),
    [&](LookRegion& region)
    {
      region = DragRegion(region, moved, right * (layout.values.Last() - layout.values.First()),
        up * (layout.gradients.Last() - layout.gradients.First()), this->Plane());
    },
    this->gesture);
}

void RegionEditor::focusInEvent(QFocusEvent* event)
{
  this->picture.hasFocus = true;
  const int count = int(this->picture.regions.size());
  if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
  {
    this->Select(event->reason() == Qt::TabFocusReason && count > 0 ? 0 : count - 1);
  }
  QWidget::focusInEvent(event);
}

void RegionEditor::focusOutEvent(QFocusEvent* event)
{
  this->picture.hasFocus = false;
  QWidget::focusOutEvent(event);
}

// Tab moves from region to region, then to the next widget.
bool RegionEditor::focusNextPrevChild(bool next)
{
  const int other = this->picture.selected + (next ? 1 : -1);
  if (this->Selected() && other >= 0 && other < int(this->picture.regions.size()))
  {
    this->Select(other);
    return true;
  }
  return QWidget::focusNextPrevChild(next);
}

void RegionEditor::contextMenuEvent(QContextMenuEvent* event)
{
  auto* const menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const QPointF at = event->pos();
  if (event->reason() == QContextMenuEvent::Mouse && this->picture.layout.plot.contains(at))
  {
    this->Select(this->picture.layout.RegionAt(this->picture.regions, at, this->picture.selected)
                   .value_or(-1));
    menu->addAction(
      tr("Add a rectangle here"), this, [this, at] { this->Add(RegionShape::Rectangle, at); });
    menu->addAction(
      tr("Add an ellipse here"), this, [this, at] { this->Add(RegionShape::Ellipse, at); });
    menu->addSeparator();
  }
  menu->addActions(this->actions());
  menu->popup(event->globalPos());
}

}
