// State and mouse handling of the editor.

#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/TransferFunctionEditor/EditorInput.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QAction>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QSettings>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double ZoomPerNotch = 1.25;
constexpr double ScalePerNotch = 1.05;
constexpr double AnglePerNotch = 120.0;
constexpr double PanPerNotch = 40.0; // [pixels]

}

TransferFunctionEditor::TransferFunctionEditor(QWidget* parent)
  : QWidget(parent)
  , mouse(this)
{
  this->setObjectName("transferFunctionEditor");
  this->setAccessibleName(tr("Transfer function"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->picture.unit = tr("value");
  this->picture.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  this->picture.look.opacities = { { 0.0, 0.0 } };
  this->MakeEditActions();
  this->MakeAxisActions();
  this->MakeScaleActions();
}

void TransferFunctionEditor::SetStatistics(std::shared_ptr<const ImageStatistics> statistics)
{
  this->picture.statistics = std::move(statistics);
  ValueAxis& axis = this->picture.layout.axis;
  axis.SetData(this->picture.statistics->Smallest(), this->picture.statistics->Largest());
  const TransferFunction function = FunctionOf(this->picture.look);
  axis.Fit(std::min(this->picture.statistics->Percentile(0.5), function.FirstValue()),
    std::max(this->picture.statistics->Percentile(99.5), function.LastValue()));
  this->update();
}

void TransferFunctionEditor::LeaveOutColors()
{
  this->picture.layout.hasColors = false;
  this->picture.look.colors.clear();
  this->removeAction(this->chooseColor);
  this->removeAction(this->asksForColor);
}

void TransferFunctionEditor::SetUnit(const QString& unit)
{
  this->picture.unit = unit;
  this->update();
}

void TransferFunctionEditor::SetLook(const Look& look)
{
  const Look shown = this->picture.look;
  this->picture.look = look;
  if (!SameCurves(look, shown))
  {
    this->mouse.Forget();
    const bool sameNumbers =
      look.opacities.size() == shown.opacities.size() && look.colors.size() == shown.colors.size();
    NodeSet kept;
    for (const NodeId& node : AllNodes(look))
    {
      const bool wasSelected =
        std::any_of(this->picture.selected.begin(), this->picture.selected.end(),
          [&](const NodeId& selected)
          {
            return selected.kind == node.kind &&
              (sameNumbers ? selected == node : ValueOf(shown, selected) == ValueOf(look, node));
          });
      if (wasSelected)
      {
        kept.insert(node);
      }
    }
    this->Select(kept);
  }
  this->update();
}

void TransferFunctionEditor::Select(const NodeSet& nodes)
{
  this->picture.selected = nodes;
  this->picture.focused.reset();
  this->update();
}

void TransferFunctionEditor::Edit(const Look& edited, const QString& stepName, int gesture)
{
  this->picture.look = edited;
  this->update();
  emit this->LookEdited(edited, stepName, gesture);
}

void TransferFunctionEditor::Add(const Insertion& insertion, const QString& stepName, int gesture)
{
  this->Edit(insertion.look, stepName, gesture);
  this->Select({ insertion.node });
}

void TransferFunctionEditor::PanAxis(double pixels)
{
  this->picture.layout.axis.Pan(pixels);
  this->update();
}

void TransferFunctionEditor::ShowRubberBand(const QRectF& band)
{
  this->picture.rubberBand = band;
  this->update();
}

void TransferFunctionEditor::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  EditorPainter(&painter, this->picture, this->palette()).Paint();
}

void TransferFunctionEditor::resizeEvent(QResizeEvent*)
{
  this->picture.layout.Resize(this->size(), QFontMetricsF(this->font()));
}

void TransferFunctionEditor::mousePressEvent(QMouseEvent* event)
{
  this->mouse.Press(*event);
}

void TransferFunctionEditor::mouseMoveEvent(QMouseEvent* event)
{
  this->wheelGesture = 0;
  if (this->mouse.IsDragging())
  {
    this->mouse.Move(*event);
  }
  this->Hover(event->localPos());
}

void TransferFunctionEditor::mouseReleaseEvent(QMouseEvent* event)
{
  this->mouse.Release(*event);
  this->Hover(event->localPos());
}

void TransferFunctionEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
  const auto node =
    this->picture.layout.NodeAt(this->picture.look, event->localPos(), this->picture.selected);
  if (node && event->button() == Qt::LeftButton)
  {
    this->Select({ *node });
    this->OpenPopover(*node);
  }
  else if (this->picture.layout.ticks.contains(event->localPos()))
  {
    this->FitToVoxels(100.0);
  }
}

void TransferFunctionEditor::wheelEvent(QWheelEvent* event)
{
  const QPointF notches = QPointF(event->angleDelta()) / AnglePerNotch;
  if (event->modifiers().testFlag(Qt::AltModifier))
  {
    // While Alt is held, Qt reports the wheel as horizontal.
    this->ScaleCurve(event->position().x(), notches.x() + notches.y());
  }
  else
  {
    this->picture.layout.axis.Zoom(event->position().x(), std::pow(ZoomPerNotch, notches.y()));
    this->picture.layout.axis.Pan(PanPerNotch * notches.x());
  }
  this->Hover(event->position());
  event->accept();
}

void TransferFunctionEditor::ScaleCurve(double pixel, double notches)
{
  this->wheelGesture = this->wheelGesture > 0 ? this->wheelGesture : NewGesture();
  const double fixed = this->picture.layout.axis.ToValue(pixel);
  this->Edit(ScaleLook(this->picture.look, std::pow(ScalePerNotch, notches), fixed),
    tr("scale the curve"), this->wheelGesture);
}

void TransferFunctionEditor::Hover(const QPointF& position)
{
  const EditorLayout& layout = this->picture.layout;
  const bool hasValue = position.x() >= layout.plot.left() && position.x() <= layout.plot.right();
  this->picture.pointer.reset();
  this->picture.reading.clear();
  if (hasValue)
  {
    this->picture.pointer = position;
    this->picture.reading = ReadingAt(this->picture, position);
  }
  this->ShowCursor(position);
  this->update();
  emit this->Hovered(this->picture.reading);
}

void TransferFunctionEditor::ShowCursor(const QPointF& position)
{
  const EditorLayout& layout = this->picture.layout;
  const bool onNode =
    layout.NodeAt(this->picture.look, position, this->picture.selected).has_value();
  const bool onColors = layout.colorBar.united(layout.stops).contains(position);
  this->setCursor(onNode                ? Qt::SizeAllCursor
      : layout.ticks.contains(position) ? Qt::OpenHandCursor
      : layout.plot.contains(position)  ? Qt::CrossCursor
      : onColors                        ? Qt::PointingHandCursor
                                        : Qt::ArrowCursor);
}

void TransferFunctionEditor::leaveEvent(QEvent*)
{
  this->picture.pointer.reset();
  this->update();
  emit this->Hovered({});
}

void TransferFunctionEditor::FitToVoxels(double percent)
{
  if (this->picture.statistics)
  {
    const double left = 0.5 * (100.0 - percent);
    this->picture.layout.axis.Fit(this->picture.statistics->Percentile(left),
      this->picture.statistics->Percentile(100.0 - left));
    this->update();
  }
}

void TransferFunctionEditor::FitToCurve()
{
  const TransferFunction function = FunctionOf(this->picture.look);
  this->picture.layout.axis.Fit(function.FirstValue(), function.LastValue());
  this->update();
}

// Keyboard commands and menus of the editor. They cover everything that the mouse can do.

namespace
{

const QString AsksForColorKey = QStringLiteral("editor/asksForColor");
constexpr double OpacityNudge = 0.01;
constexpr double LargeNudge = 10.0;

}

void TransferFunctionEditor::MakeEditActions()
{
  connect(AddKeyAction(this, tr("Edit numbers…"), Qt::Key_Return), &QAction::triggered, this,
    [this]
    {
      if (!this->picture.selected.empty())
      {
        this->OpenPopover(*this->picture.selected.begin());
      }
    });
  this->chooseColor = AddKeyAction(this, tr("Colour…"), Qt::Key_C);
  connect(this->chooseColor, &QAction::triggered, this, &TransferFunctionEditor::ChooseColor);
  connect(AddKeyAction(this, tr("Delete"), Qt::Key_Delete), &QAction::triggered, this,
    &TransferFunctionEditor::DeleteSelected);
  connect(AddKeyAction(this, tr("Add a point after the selected one"), Qt::Key_Insert),
    &QAction::triggered, this, &TransferFunctionEditor::AddBesideSelected);
  connect(AddKeyAction(this, tr("Select all"), QKeySequence::SelectAll), &QAction::triggered, this,
    [this] { this->Select(AllNodes(this->picture.look)); });
  this->asksForColor = AddKeyAction(this, tr("Ask for the colour of a new point"), Qt::Key_P);
  this->asksForColor->setCheckable(true);
  this->asksForColor->setChecked(QSettings().value(AsksForColorKey).toBool());
  connect(this->asksForColor, &QAction::triggered, this,
    [](bool on) { QSettings().setValue(AsksForColorKey, on); });
  auto* const separator = new QAction(this);
  separator->setSeparator(true);
  this->addAction(separator);
}

void TransferFunctionEditor::MakeAxisActions()
{
  QAction* const all = AddKeyAction(this, tr("Show all values"), Qt::Key_F);
  all->setIconText(tr("All"));
  connect(all, &QAction::triggered, this,
    [this]
    {
      this->showMost->setChecked(false);
      this->FitToVoxels(100.0);
    });
  this->showMost = AddKeyAction(this, tr("Hide the outermost 1 % of the voxels"), Qt::Key_H);
  this->showMost->setIconText(tr("99 %"));
  this->showMost->setCheckable(true);
  connect(this->showMost, &QAction::triggered, this,
    [this](bool most) { this->FitToVoxels(most ? 99.0 : 100.0); });
  QAction* const curve = AddKeyAction(this, tr("Show the curve"), Qt::Key_E);
  curve->setIconText(tr("Curve"));
  connect(curve, &QAction::triggered, this, &TransferFunctionEditor::FitToCurve);
  this->viewActions = { all, this->showMost, curve };
}

void TransferFunctionEditor::MakeScaleActions()
{

  QAction* const logarithmic = AddKeyAction(this, tr("Logarithmic counts"), Qt::Key_L);
  logarithmic->setIconText(tr("Log"));
  logarithmic->setCheckable(true);
  logarithmic->setChecked(this->picture.logarithmicCounts);
  connect(logarithmic, &QAction::toggled, this,
    [this](bool on)
    {
      this->picture.logarithmicCounts = on;
      this->update();
    });
  QAction* const low = AddKeyAction(this, tr("Enlarge low opacities"), Qt::Key_O);
  low->setIconText(tr("Low"));
  low->setCheckable(true);
  connect(low, &QAction::toggled, this,
    [this](bool on)
    {
      this->picture.layout.lowOpacitiesEnlarged = on;
      this->update();
    });
  this->viewActions.append({ logarithmic, low });
}

bool TransferFunctionEditor::event(QEvent* event)
{
  // While the editor has the focus, its keys override the window's shortcuts.
  if (event->type() == QEvent::ShortcutOverride)
  {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (IsArrowKey(key.key()) || ActionOfKey(*this, key) ||
      (key.key() == Qt::Key_Escape && this->mouse.IsDragging()))
    {
      event->accept();
    }
  }
  return QWidget::event(event);
}

void TransferFunctionEditor::keyPressEvent(QKeyEvent* event)
{
  if (QAction* const action = ActionOfKey(*this, *event))
  {
    action->trigger();
  }
  else if (IsArrowKey(event->key()))
  {
    this->Nudge(*event);
  }
  else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus)
  {
    const double factor = event->key() == Qt::Key_Plus ? ZoomPerKey : 1.0 / ZoomPerKey;
    this->picture.layout.axis.Zoom(this->picture.layout.plot.center().x(), factor);
    this->update();
  }
  else if (event->key() == Qt::Key_Escape && this->mouse.IsDragging())
  {
    this->mouse.Cancel();
  }
  else
  {
    QWidget::keyPressEvent(event);
  }
}

double TransferFunctionEditor::NudgeStep() const
{
  // Steps of one unit, such as one Hounsfield unit; smaller for data with a small range.
  const auto& statistics = this->picture.statistics;
  const double width = statistics ? statistics->Largest() - statistics->Smallest() : 0.0;
  return width > 0.0 ? std::min(1.0, std::pow(10.0, std::floor(std::log10(width)) - 2.0)) : 1.0;
}

void TransferFunctionEditor::Nudge(const QKeyEvent& event)
{
  if (this->picture.selected.empty())
  {
    this->Focus(*AllNodes(this->picture.look).begin());
    return;
  }
  this->keyGesture = event.isAutoRepeat() ? this->keyGesture : NewGesture();
  const double size = event.modifiers().testFlag(Qt::ShiftModifier) ? LargeNudge : 1.0;
  const int key = event.key();
  const double right = key == Qt::Key_Right ? size : key == Qt::Key_Left ? -size : 0.0;
  const double up = key == Qt::Key_Up ? size : key == Qt::Key_Down ? -size : 0.0;
  this->Edit(MoveNodes(this->picture.look, this->picture.selected, right * this->NudgeStep(),
               up * OpacityNudge),
    tr("nudge points"), this->keyGesture);
}

void TransferFunctionEditor::Focus(const NodeId& node)
{
  this->Select({ node });
  this->picture.focused = node;
  this->setAccessibleDescription(DescriptionOf(this->picture, node));
}

void TransferFunctionEditor::focusInEvent(QFocusEvent* event)
{
  QWidget::focusInEvent(event);
  const NodeSet nodes = AllNodes(this->picture.look);
  if (event->reason() == Qt::TabFocusReason)
  {
    this->Focus(*nodes.begin());
  }
  else if (event->reason() == Qt::BacktabFocusReason)
  {
    this->Focus(*nodes.rbegin());
  }
}

// Tab moves from node to node, then to the next widget.
bool TransferFunctionEditor::focusNextPrevChild(bool next)
{
  const NodeSet nodes = AllNodes(this->picture.look);
  if (!this->picture.selected.empty())
  {
    const auto current = nodes.find(*this->picture.selected.begin());
    if (next ? std::next(current) != nodes.end() : current != nodes.begin())
    {
      this->Focus(next ? *std::next(current) : *std::prev(current));
      return true;
    }
  }
  this->picture.focused.reset();
  return QWidget::focusNextPrevChild(next);
}

void TransferFunctionEditor::DeleteSelected()
{
  if (!this->picture.selected.empty())
  {
    const Look changed =
      RemoveNodes(this->picture.look, this->picture.selected, this->picture.layout.LongestRamp());
    const QString name =
      this->picture.selected.size() > 1 ? tr("delete points") : tr("delete point");
    this->Select({});
    this->Edit(changed, name, NewGesture());
  }
}

void TransferFunctionEditor::AddBesideSelected()
{
  // Halfway to the next point, or at the centre of the axis.
  std::vector<double> values;
  for (const NodeId& node : AllNodes(this->picture.look))
  {
    if (node.kind != NodeKind::Color)
    {
      values.push_back(ValueOf(this->picture.look, node));
    }
  }
  const ValueAxis& axis = this->picture.layout.axis;
  double value = axis.Rounded(0.5 * (axis.First() + axis.Last()), 1.0);
  if (!this->picture.selected.empty())
  {
    const double selected = ValueOf(this->picture.look, *this->picture.selected.begin());
    const auto next = std::upper_bound(values.begin(), values.end(), selected);
    value = next != values.end() ? 0.5 * (selected + *next) : value;
  }
  const bool surface = this->picture.look.blend == Blend::Isosurface;
  const double opacity = surface ? 1.0 : FunctionOf(this->picture.look).Opacity(value);
  const Insertion added =
    InsertPoint(this->picture.look, value, opacity, this->picture.layout.LongestRamp());
  this->Add(added, tr("add point"), NewGesture());
  this->Focus(added.node);
}

void TransferFunctionEditor::ChooseColor()
{
  if (this->picture.selected.empty() || !this->picture.layout.hasColors)
  {
    return;
  }
  const NodeSet nodes = this->picture.selected;
  const Look before = this->picture.look;
  const int gesture = NewGesture();
  const auto color = [=](const QColor& chosen)
  {
    // From the last node to the first: inserted colour nodes shift the indices of later ones.
    Look changed = before;
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
    {
      changed = SetColor(changed, *node, { chosen.redF(), chosen.greenF(), chosen.blueF() });
    }
    this->Edit(changed, tr("choose colour"), gesture);
  };
  const QColorDialog* const dialog =
    OpenLiveColorDialog(QColorOf(ColorOf(before, *nodes.begin())), color, this);
  connect(
    dialog, &QDialog::rejected, this, [=] { this->Edit(before, tr("choose colour"), gesture); });
}

void TransferFunctionEditor::AskForColorIfWanted()
{
  if (this->asksForColor->isChecked())
  {
    this->ChooseColor();
  }
}

void TransferFunctionEditor::OpenPopover(const NodeId& node)
{
  const int gesture = NewGesture();
  auto* const popover = new NodePopover(this->picture.look, node, this->picture.unit,
    std::max(1, this->picture.layout.axis.Decimals()), this);
  connect(popover, &NodePopover::Edited, this,
    [this, gesture](const Look& edited) { this->Edit(edited, tr("edit point"), gesture); });
  connect(popover, &NodePopover::DeleteWanted, this,
    [this, popover]
    {
      popover->close();
      this->DeleteSelected();
    });
  connect(popover, &NodePopover::ColorWanted, this,
    [this, popover]
    {
      popover->close();
      this->ChooseColor();
    });
  const QPointF at = this->picture.layout.PositionOf(this->picture.look, node);
  popover->adjustSize();
  const QPoint wanted = this->mapToGlobal(at.toPoint() + QPoint(12, 12));
  const QRect screen = this->screen()->availableGeometry();
  popover->move(std::min(wanted.x(), screen.right() - popover->width()),
    std::min(wanted.y(), screen.bottom() - popover->height()));
  popover->show();
}

void TransferFunctionEditor::contextMenuEvent(QContextMenuEvent* event)
{
  const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
  const QPointF at = event->pos();
  const auto node = this->picture.layout.NodeAt(this->picture.look, at, this->picture.selected);
  if (byMouse && node && this->picture.selected.count(*node) == 0)
  {
    this->Select({ *node });
  }
  auto* const menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (byMouse && !node && this->picture.layout.plot.contains(at))
  {
    menu->addAction(tr("Add a point here"), this,
      [this, at]
      {
        const EditorLayout& layout = this->picture.layout;
        this->Add(
          InsertPoint(this->picture.look, layout.axis.Rounded(layout.axis.ToValue(at.x()), 1.0),
            layout.ToOpacity(at.y()), layout.LongestRamp()),
          tr("add point"), NewGesture());
      });
    menu->addSeparator();
  }
  menu->addActions(this->actions());
  menu->popup(event->globalPos());
}

}
