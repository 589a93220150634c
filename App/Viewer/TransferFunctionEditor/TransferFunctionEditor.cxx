// State and mouse handling of the editor. Its actions and keys are in EditorCommands.cxx.

#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include "Viewer/Model/Gesture.h"
#include "Viewer/TransferFunctionEditor/EditorReading.h"

#include <QAction>
#include <QMouseEvent>
#include <QPainter>
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

}
