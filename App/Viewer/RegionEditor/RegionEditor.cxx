// State and mouse handling of the editor.

#include "Viewer/RegionEditor/RegionEditor.h"

#include "Scene/Looks/LookRegions.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/TransferFunctionEditor/EditorInput.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QAction>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double ZoomPerWheelNotch = 1.25;
constexpr double AnglePerWheelNotch = 120.0;

}

RegionEditor::RegionEditor(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("regionEditor");
  this->setAccessibleName(tr("Regions of value and gradient"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->MakeActions();
}

void RegionEditor::SetHistogram(std::shared_ptr<const ValueGradientHistogram> histogram)
{
  this->picture.histogram = std::move(histogram);
  this->picture.counts =
    PictureOfCounts(*this->picture.histogram, this->palette().color(QPalette::Text));
  this->picture.layout.values.SetData(
    this->picture.histogram->values[0], this->picture.histogram->values[1]);
  this->picture.layout.gradients.SetData(0.0, this->picture.histogram->largestGradient);
  this->ShowAll();
}

void RegionEditor::SetUnit(const QString& unit)
{
  this->picture.unit = unit;
}

void RegionEditor::SetRegions(const std::vector<LookRegion>& regions)
{
  this->picture.regions = regions;
  if (this->picture.selected >= int(regions.size()))
  {
    this->drag = Drag::None;
    this->Select(int(regions.size()) - 1);
  }
  this->update();
}

const LookRegion* RegionEditor::Selected() const
{
  return this->picture.selected >= 0 ? &this->picture.regions[std::size_t(this->picture.selected)]
                                     : nullptr;
}

void RegionEditor::Select(int index)
{
  this->picture.selected = index;
  this->update();
  emit this->SelectionChanged();
}

void RegionEditor::EditSelected(
  const QString& stepName, const std::function<void(LookRegion&)>& change, int changeGesture)
{
  std::vector<LookRegion> regions = this->picture.regions;
  change(regions[std::size_t(this->picture.selected)]);
  this->Edit(regions, stepName, changeGesture);
}

void RegionEditor::Edit(
  const std::vector<LookRegion>& regions, const QString& stepName, int changeGesture)
{
  this->picture.regions = regions;
  this->update();
  emit this->RegionsEdited(regions, stepName, changeGesture);
}

RegionPlane RegionEditor::Plane() const
{
  return this->picture.histogram
    ? RegionPlane{ this->picture.histogram->values, this->picture.histogram->largestGradient }
    : RegionPlane();
}

void RegionEditor::ShowAll()
{
  const RegionPlane plane = this->Plane();
  this->picture.layout.values.Fit(plane.values[0], plane.values[1]);
  this->picture.layout.gradients.Fit(0.0, plane.largestGradient);
  this->update();
}

void RegionEditor::Zoom(const QPointF& position, double factor)
{
  RegionLayout& layout = this->picture.layout;
  layout.values.Zoom(position.x(), factor);
  layout.gradients.Zoom(layout.plot.bottom() - position.y(), factor);
  this->update();
}

void RegionEditor::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  PaintRegions(painter, this->picture, this->palette());
}

void RegionEditor::resizeEvent(QResizeEvent*)
{
  const QFontMetricsF font(this->font());
  this->picture.layout.Resize(this->size(), font.height(), font.horizontalAdvance("00000"));
}

void RegionEditor::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange && this->picture.histogram)
  {
    this->picture.counts =
      PictureOfCounts(*this->picture.histogram, this->palette().color(QPalette::Text));
  }
  QWidget::changeEvent(event);
}

void RegionEditor::mousePressEvent(QMouseEvent* event)
{
  this->pressed = this->last = event->localPos();
  this->gesture = NewGesture();
  if (event->button() == Qt::MiddleButton)
  {
    this->drag = Drag::Plane;
    return;
  }
  if (event->button() != Qt::LeftButton)
  {
    return;
  }
  const RegionLayout& layout = this->picture.layout;
  const LookRegion* const selected = this->Selected();
  const auto onHandle = selected ? layout.HandleAt(*selected, this->pressed) : std::nullopt;
  const auto under = layout.RegionAt(this->picture.regions, this->pressed, this->picture.selected);
  if (!onHandle)
  {
    this->Select(under.value_or(-1));
  }
  if (onHandle || under)
  {
    this->drag = Drag::Region;
    this->handle = onHandle.value_or(RegionHandle());
    this->atPress = *this->Selected();
  }
}

void RegionEditor::mouseMoveEvent(QMouseEvent* event)
{
  if (this->drag == Drag::Region)
  {
    this->DragTo(event->localPos());
  }
  else if (this->drag == Drag::Plane)
  {
    const QPointF moved = event->localPos() - this->last;
    this->picture.layout.values.Pan(moved.x());
    this->picture.layout.gradients.Pan(-moved.y());
    this->update();
  }
  this->last = event->localPos();
  this->Hover(event->localPos());
}

void RegionEditor::DragTo(const QPointF& position)
{
  const RegionLayout& layout = this->picture.layout;
  const double value = layout.ToValue(position.x()) - layout.ToValue(this->pressed.x());
  const double gradient = layout.ToGradient(position.y()) - layout.ToGradient(this->pressed.y());
  const bool moves = this->handle.value == 0 && this->handle.gradient == 0;
  this->EditSelected(
    moves ? tr("move a region") : tr("resize a region"),
    [&](LookRegion& region)
    { region = DragRegion(this->atPress, this->handle, value, gradient, this->Plane()); },
    this->gesture);
}

void RegionEditor::CancelDrag()
{
  if (this->drag == Drag::Region)
  {
    this->DragTo(this->pressed);
  }
  this->drag = Drag::None;
}

void RegionEditor::mouseReleaseEvent(QMouseEvent* event)
{
  this->drag = Drag::None;
  this->Hover(event->localPos());
}

void RegionEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->Selected())
  {
    this->drag = Drag::None;
    this->ChooseColor();
  }
}

void RegionEditor::wheelEvent(QWheelEvent* event)
{
  const double notches = event->angleDelta().y() / AnglePerWheelNotch;
  this->Zoom(event->position(), std::pow(ZoomPerWheelNotch, notches));
  event->accept();
}

void RegionEditor::Hover(const QPointF& position)
{
  const RegionLayout& layout = this->picture.layout;
  this->picture.reading.clear();
  if (layout.plot.contains(position) && this->picture.histogram)
  {
    const double value = layout.ToValue(position.x());
    const double gradient = layout.ToGradient(position.y());
    const QLocale locale;
    this->picture.reading =
      tr("%1 %2, gradient %3 per mm: %4 voxels")
        .arg(locale.toString(value, 'f', layout.values.Decimals()), this->picture.unit,
          locale.toString(gradient, 'f', layout.gradients.Decimals()),
          locale.toString(qlonglong(this->picture.histogram->CountAt(value, gradient))));
  }
  const LookRegion* const selected = this->Selected();
  const bool onHandle = selected && layout.HandleAt(*selected, position);
  this->setCursor(onHandle ? Qt::SizeAllCursor
      : layout.RegionAt(this->picture.regions, position, this->picture.selected)
      ? Qt::OpenHandCursor
      : Qt::ArrowCursor);
  this->update();
}

void RegionEditor::leaveEvent(QEvent*)
{
  this->picture.reading.clear();
  this->update();
}

// Keyboard commands and menus of the editor of regions. They cover everything that the mouse can
// do.

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
