#include "Viewer/Tools/MouseTools.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <map>

namespace varimarch
{

std::optional<MeasureKind> MeasureOf(LeftButton button)
{
  static const std::map<LeftButton, MeasureKind> kinds = { { LeftButton::Distance,
                                                             MeasureKind::Distance },
    { LeftButton::Angle, MeasureKind::Angle }, { LeftButton::CobbAngle, MeasureKind::CobbAngle },
    { LeftButton::Box, MeasureKind::Box }, { LeftButton::Ellipse, MeasureKind::Ellipse },
    { LeftButton::Freehand, MeasureKind::Freehand }, { LeftButton::Curve, MeasureKind::Curve },
    { LeftButton::Arrow, MeasureKind::Arrow }, { LeftButton::Text, MeasureKind::Text } };
  const auto kind = kinds.find(button);
  return kind == kinds.end() ? std::nullopt : std::optional(kind->second);
}

MouseTools::MouseTools(
  SceneModel* model, ToolSurface& surface, const std::function<Camera()>& camera)
  : handles(model, surface)
  , measure(model, surface)
  , scissors(model, surface, camera)
  , brightness(model, surface)
  , walk(model, surface, camera)
{
}

void MouseTools::Choose(LeftButton button)
{
  this->chosen = nullptr;
  this->walk.Stand();
  if (const auto kind = MeasureOf(button))
  {
    this->measure.SetKind(*kind);
    this->chosen = &this->measure;
  }
  else if (button == LeftButton::Brightness)
  {
    this->chosen = &this->brightness;
  }
  else if (button == LeftButton::Walk)
  {
    this->chosen = &this->walk;
  }
  else if (button != LeftButton::Turn)
  {
    this->scissors.SetKeepsInside(button == LeftButton::KeepOnly);
    this->chosen = &this->scissors;
  }
}

bool MouseTools::Take(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return this->Press(static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return this->Move(static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return this->Release(static_cast<QMouseEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return this->Key(event);
    case QEvent::FocusOut:
      this->walk.Stand();
      return false;
    default:
      return false;
  }
}

bool MouseTools::Key(QEvent* event)
{
  auto* const key = static_cast<QKeyEvent*>(event);
  if (this->chosen == &this->walk && this->walk.TakeKey(key))
  {
    return true;
  }
  return event->type() == QEvent::KeyPress && key->key() == Qt::Key_Escape && this->Cancel();
}

bool MouseTools::Move(QMouseEvent* mouse)
{
  this->handles.Hover(mouse->localPos());
  if (this->active)
  {
    this->active->Drag(mouse->localPos());
  }
  return this->active != nullptr;
}

bool MouseTools::Release(QMouseEvent* mouse)
{
  if (!this->active || mouse->button() != Qt::LeftButton)
  {
    return false;
  }
  this->active->Release(mouse->localPos());
  this->SetActive(nullptr);
  return true;
}

bool MouseTools::Cancel()
{
  if (!this->active)
  {
    return false;
  }
  this->active->Cancel();
  this->SetActive(nullptr);
  return true;
}

// An outline needs every move, also those made while the program was busy. For other tools only the
// last position counts, so Qt may leave out the moves before it.
void MouseTools::SetActive(MouseTool* tool)
{
  this->active = tool;
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, tool != &this->scissors);
}

// During a gesture, presses of other buttons are swallowed, so that the camera does not turn.
bool MouseTools::Press(QMouseEvent* mouse)
{
  if (this->active || mouse->button() != Qt::LeftButton)
  {
    return this->active != nullptr;
  }
  MouseTool* const tool = this->ToolFor(mouse);
  if (tool && tool->Press(mouse->localPos()))
  {
    this->SetActive(tool);
  }
  return tool != nullptr;
}

MouseTool* MouseTools::ToolFor(QMouseEvent* mouse)
{
  if (mouse->modifiers() & Qt::ControlModifier)
  {
    return &this->brightness;
  }
  return this->handles.IsOver(mouse->localPos()) ? &this->handles : this->chosen;
}

Qt::CursorShape MouseTools::Cursor(const QPointF& place) const
{
  if (this->handles.IsOver(place))
  {
    return Qt::SizeAllCursor;
  }
  return this->chosen ? Qt::CrossCursor : Qt::ArrowCursor;
}

void MouseTools::Paint(QPainter& painter) const
{
  this->handles.Paint(painter);
  if (this->chosen)
  {
    this->chosen->Paint(painter);
  }
}

}
