#include "Viewer/TransferFunctionEditor/EditorMouse.h"

#include "Viewer/Model/Gesture.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QMouseEvent>

#include <cmath>

namespace varimarch
{

namespace
{

// Shorter motions count as clicks [pixels].
constexpr double LeastDrag = 3.0;
// Speed of a fine drag relative to the pointer.
constexpr double FineSpeed = 0.1;

double RoundedOpacity(double opacity)
{
  return std::round(1000.0 * opacity) / 1000.0;
}

}

EditorMouse::EditorMouse(TransferFunctionEditor* editor)
  : editor(editor)
{
}

void EditorMouse::Press(const QMouseEvent& event)
{
  const EditorPicture& picture = this->editor->Picture();
  this->drag = Drag::None;
  this->gesture = NewGesture();
  this->pressed = this->last = event.localPos();
  this->travelled = QPointF();
  this->moved = false;
  this->atPress = picture.look;
  this->selectedAtPress = picture.selected;

  const auto node = picture.layout.NodeAt(picture.look, this->pressed, picture.selected);
  if (event.button() == Qt::MiddleButton)
  {
    this->drag = Drag::Axis;
  }
  else if (event.button() != Qt::LeftButton)
  {
    return;
  }
  else if (event.modifiers().testFlag(Qt::AltModifier))
  {
    this->PressWholeCurve();
  }
  else if (node)
  {
    this->PressNode(*node, event.modifiers().testFlag(Qt::ControlModifier));
  }
  else
  {
    this->drag = picture.layout.ticks.contains(this->pressed) ? Drag::Axis : Drag::Begun;
  }
}

void EditorMouse::PressNode(const NodeId& node, bool toggles)
{
  NodeSet selected = this->selectedAtPress;
  this->selectedByClick = NodeSet{ node };
  if (toggles)
  {
    this->selectedByClick = selected;
    if (this->selectedByClick.erase(node) == 0)
    {
      this->selectedByClick.insert(node);
    }
    selected.insert(node);
  }
  else if (selected.count(node) == 0)
  {
    selected = { node };
  }
  this->editor->Select(selected);
  this->horizontal = node.kind == NodeKind::Color;
  this->name = selected.size() > 1 ? TransferFunctionEditor::tr("move points")
    : this->horizontal             ? TransferFunctionEditor::tr("move colour")
                                   : TransferFunctionEditor::tr("move point");
  this->Grab(selected, ValueOf(this->atPress, node),
    this->horizontal ? 0.0 : OpacityOf(this->atPress, node));
}

void EditorMouse::PressWholeCurve()
{
  this->selectedByClick = this->selectedAtPress;
  this->horizontal = true;
  this->name = TransferFunctionEditor::tr("shift the curve");
  const ValueAxis& axis = this->editor->Picture().layout.axis;
  this->Grab(AllNodes(this->atPress), axis.ToValue(this->pressed.x()), 0.0);
}

void EditorMouse::Grab(const NodeSet& nodes, double value, double opacity)
{
  this->drag = Drag::Nodes;
  this->base = this->editor->Picture().look;
  this->grabbed = nodes;
  this->anchorValue = value;
  this->anchorOpacity = opacity;
}

void EditorMouse::Move(const QMouseEvent& event)
{
  const bool fine = event.modifiers().testFlag(Qt::ControlModifier);
  const QPointF step = event.localPos() - this->last;
  this->last = event.localPos();
  this->travelled += (fine ? FineSpeed : 1.0) * step;
  if (!this->moved && (this->last - this->pressed).manhattanLength() < LeastDrag)
  {
    return;
  }
  if (!this->moved && this->drag == Drag::Begun)
  {
    this->BeginFromEmpty();
  }
  this->moved = true;
  QPointF way = this->travelled;
  if (event.modifiers().testFlag(Qt::ShiftModifier))
  {
    (std::abs(way.x()) < std::abs(way.y()) ? way.rx() : way.ry()) = 0.0;
  }
  if (this->drag == Drag::Nodes || this->drag == Drag::NewPoint)
  {
    this->MoveNodes(way, fine);
  }
  else if (this->drag == Drag::Axis)
  {
    this->editor->PanAxis(step.x());
  }
  else if (this->drag == Drag::RubberBand)
  {
    this->SelectInBand();
  }
}

// A drag that starts on the curve or the colour bar creates a new point or colour; elsewhere in the
// plot it draws a rubber band.
void EditorMouse::BeginFromEmpty()
{
  const EditorPicture& picture = this->editor->Picture();
  const bool inPlot = picture.layout.plot.contains(this->pressed);
  if (inPlot && !picture.layout.IsOnCurve(picture.look, this->pressed))
  {
    this->drag = Drag::RubberBand;
  }
  else if (this->AddAt(this->pressed))
  {
    const NodeId added = *picture.selected.begin();
    this->horizontal = added.kind == NodeKind::Color;
    this->Grab({ added }, ValueOf(picture.look, added),
      this->horizontal ? 0.0 : OpacityOf(picture.look, added));
    this->drag = inPlot ? Drag::NewPoint : Drag::Nodes;
  }
}

/// Adds a node at the position; returns false if nothing can be added there.
bool EditorMouse::AddAt(const QPointF& position)
{
  const EditorLayout& layout = this->editor->Picture().layout;
  const double value = layout.axis.Rounded(layout.axis.ToValue(position.x()), 1.0);
  if (layout.plot.contains(position))
  {
    const double opacity = RoundedOpacity(layout.ToOpacity(position.y()));
    this->name = TransferFunctionEditor::tr("add point");
    this->editor->Add(
      InsertPoint(this->atPress, value, opacity, layout.LongestRamp()), this->name, this->gesture);
    return true;
  }
  if (this->atPress.blend != Blend::Isosurface &&
    layout.colorBar.united(layout.stops).contains(position))
  {
    this->name = TransferFunctionEditor::tr("add colour");
    this->editor->Add(InsertColor(this->atPress, value), this->name, this->gesture);
    return true;
  }
  return false;
}

void EditorMouse::MoveNodes(const QPointF& way, bool fine)
{
  const EditorLayout& layout = this->editor->Picture().layout;
  double valueShift = 0.0;
  if (way.x() != 0.0)
  {
    const double value = this->anchorValue + way.x() * layout.axis.ValuePerPixel();
    valueShift = layout.axis.Rounded(value, fine ? FineSpeed : 1.0) - this->anchorValue;
  }
  double opacityShift = 0.0;
  if (way.y() != 0.0 && !this->horizontal)
  {
    const double y = layout.ToY(this->anchorOpacity) + way.y();
    opacityShift = RoundedOpacity(layout.ToOpacity(y)) - this->anchorOpacity;
  }
  if (this->drag == Drag::NewPoint)
  {
    // Insert the point anew at every position, since its additional dark node depends on it.
    const double value =
      WithinNeighbors(this->atPress, this->anchorValue, this->anchorValue + valueShift);
    this->editor->Add(
      InsertPoint(this->atPress, value, this->anchorOpacity + opacityShift, layout.LongestRamp()),
      this->name, this->gesture);
    return;
  }
  this->editor->Edit(varimarch::MoveNodes(this->base, this->grabbed, valueShift, opacityShift),
    this->name, this->gesture);
}

void EditorMouse::SelectInBand()
{
  const EditorPicture& picture = this->editor->Picture();
  const QRectF band = QRectF(this->pressed, this->last).normalized();
  NodeSet selected;
  for (const NodeId& node : AllNodes(picture.look))
  {
    if (band.contains(picture.layout.PositionOf(picture.look, node)))
    {
      selected.insert(node);
    }
  }
  this->editor->ShowRubberBand(band);
  this->editor->Select(selected);
}

void EditorMouse::Release(const QMouseEvent& event)
{
  const Drag ended = this->drag;
  this->drag = Drag::None;
  this->editor->ShowRubberBand({});
  if (this->moved)
  {
    return;
  }
  if (ended == Drag::Nodes)
  {
    this->editor->Select(this->selectedByClick);
  }
  else if (ended == Drag::Begun && !event.modifiers().testFlag(Qt::ControlModifier) &&
    this->AddAt(this->pressed))
  {
    this->editor->AskForColorIfWanted();
  }
}

void EditorMouse::Cancel()
{
  const bool changesLook =
    (this->drag == Drag::Nodes || this->drag == Drag::NewPoint) && this->moved;
  this->drag = Drag::None;
  this->editor->ShowRubberBand({});
  if (changesLook)
  {
    this->editor->Edit(this->atPress, this->name, this->gesture);
  }
  this->editor->Select(this->selectedAtPress);
}

}
