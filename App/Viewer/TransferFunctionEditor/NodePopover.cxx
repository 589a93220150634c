#include "Viewer/TransferFunctionEditor/NodePopover.h"

#include "Viewer/TransferFunctionEditor/EditorPainter.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalBlocker>

#include <cmath>

namespace varimarch
{

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
