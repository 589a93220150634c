#include "Viewer/TransferFunctionEditor/EditorInput.h"

#include "Viewer/Model/SceneModel.h"
#include "Viewer/TransferFunctionEditor/EditorPainter.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QWidget>

#include <cmath>

namespace varimarch
{

bool IsArrowKey(int key)
{
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

QAction* AddKeyAction(QWidget* editor, const QString& text, const QKeySequence& key)
{
  auto* const action = new QAction(text, editor);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetShortcut);
  editor->addAction(action);
  return action;
}

QAction* ActionOfKey(const QWidget& editor, const QKeyEvent& event)
{
  const int modifiers = int(event.modifiers() & ~Qt::KeypadModifier);
  const QKeySequence keys(event.key() == Qt::Key_Enter ? int(Qt::Key_Return)
      : event.key() == Qt::Key_Backspace               ? int(Qt::Key_Delete)
                                                       : event.key() | modifiers);
  for (QAction* const action : editor.actions())
  {
    if (!action->isSeparator() && action->shortcut() == keys)
    {
      return action;
    }
  }
  return nullptr;
}

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

namespace
{

constexpr double LargestValue = 1e9;

}

NodePopover::NodePopover(
  const Look& look, const NodeId& node, const QString& unit, int decimals, QWidget* parent)
  : QFrame(parent, Qt::Popup)
  , before(look)
  , look(look)
  , node(node)
  , form(new QFormLayout(this))
{
  this->setObjectName("nodePopover");
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->setFrameShape(QFrame::StyledPanel);
  this->value = this->AddNumber(unit, "value", ValueOf(look, node));
  this->value->setDecimals(decimals);
  this->value->setRange(-LargestValue, LargestValue);
  this->value->setSingleStep(std::pow(10.0, -decimals));
  connect(this->value, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double entered) { this->Apply(SetValue(this->look, this->node, entered)); });
  if (node.kind != NodeKind::Color)
  {
    this->opacity = this->AddNumber(tr("Opacity"), "opacity", 0.0);
    connect(this->opacity, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      [this](double entered) { this->Apply(SetOpacity(this->look, this->node, entered)); });
  }
  if (node.kind != NodeKind::Surface)
  {
    this->AddShape();
  }
  this->ShowNumbers();
  this->AddButtons();
  this->value->setFocus();
  this->value->selectAll();
}

void NodePopover::AddShape()
{
  this->midpoint = this->AddNumber(tr("Midpoint"), "midpoint", 0.5);
  this->midpoint->setToolTip(tr("Position where the curve is halfway to the next point"));
  this->sharpness = this->AddNumber(tr("Sharpness"), "sharpness", 0.0);
  this->sharpness->setToolTip(tr("0 is a straight line to the next point, 1 is a step"));
  for (QDoubleSpinBox* const number : { this->midpoint, this->sharpness })
  {
    connect(number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      [this] { this->Apply(SetShape(this->look, this->node, this->EnteredShape())); });
  }
}

QDoubleSpinBox* NodePopover::AddNumber(const QString& name, const char* objectName, double number)
{
  auto* const box = new QDoubleSpinBox;
  box->setObjectName(objectName);
  box->setDecimals(3);
  box->setRange(0.0, 1.0);
  box->setSingleStep(0.01);
  box->setValue(number);
  // Do not apply numbers that are only half typed.
  box->setKeyboardTracking(false);
  connect(box, &QAbstractSpinBox::editingFinished, this, &NodePopover::ShowNumbers);
  this->form->addRow(name, box);
  return box;
}

void NodePopover::AddButtons()
{
  if (!this->look.colors.empty())
  {
    auto* const color = new QPushButton(tr("Choose…"));
    color->setObjectName("color");
    QPixmap sample(16, 16);
    sample.fill(QColorOf(ColorOf(this->look, this->node)));
    color->setIcon(sample);
    connect(color, &QPushButton::clicked, this, &NodePopover::ColorWanted);
    this->form->addRow(tr("Colour"), color);
  }
  auto* const remove = new QPushButton(tr("Delete"));
  remove->setObjectName("delete");
  connect(remove, &QPushButton::clicked, this, &NodePopover::DeleteWanted);
  this->form->addRow(remove);
}

void NodePopover::Apply(const Look& edited)
{
  this->look = edited;
  emit this->Edited(edited);
}

// Shows the applied numbers, which neighbouring nodes may have limited.
void NodePopover::ShowNumbers()
{
  const QSignalBlocker blockers[] = { QSignalBlocker(this->value), QSignalBlocker(this->opacity),
    QSignalBlocker(this->midpoint), QSignalBlocker(this->sharpness) };
  this->value->setValue(ValueOf(this->look, this->node));
  if (this->midpoint)
  {
    const NodeShape shape = ShapeOf(this->look, this->node);
    this->midpoint->setValue(shape.midpoint);
    this->sharpness->setValue(shape.sharpness);
  }
  if (this->opacity)
  {
    this->opacity->setValue(OpacityOf(this->look, this->node));
  }
}

NodeShape NodePopover::EnteredShape() const
{
  return { this->midpoint->value(), this->sharpness->value() };
}

void NodePopover::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape)
  {
    this->Apply(this->before);
    // Hiding the popover would otherwise apply a half-typed number.
    this->ShowNumbers();
    this->close();
  }
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
  {
    this->close();
  }
  else
  {
    QFrame::keyPressEvent(event);
  }
}

}
