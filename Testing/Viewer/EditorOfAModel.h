#ifndef Varimarch_Testing_EditorOfAModel_h
#define Varimarch_Testing_EditorOfAModel_h

#include "SmallStudy.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace varimarch
{

/// An editor connected to a model in both directions. A new CT has the look for bone, with points
/// at 150, 300, 600 and 1500, each with its own colour.
class EditorOfAModel : public testing::Test
{
protected:
  EditorOfAModel()
  {
    qRegisterMetaType<Look>("varimarch::Look");
    QObject::connect(&this->editor, &TransferFunctionEditor::LookEdited,
      [this](const Look& look, const QString& name, int gesture)
      { this->model.SetLook(look, name, gesture); });
    QObject::connect(
      &this->model, &SceneModel::Changed, [this] { this->editor.SetLook(this->Edited()); });
    this->model.Open(ProceduralSource(), SmallStudy());
    const auto study = this->model.CurrentStudy();
    this->editor.resize(600, 300);
    this->editor.show();
    this->editor.SetUnit("HU");
    this->editor.SetStatistics({ study, &study->statistics });
  }

  const Look& Edited() const { return this->model.CurrentScene().look; }
  const EditorLayout& Layout() const { return this->editor.Picture().layout; }
  int Steps() { return this->model.History()->count(); }

  QPoint At(int point) const
  {
    return this->Layout().PositionOf(this->Edited(), { NodeKind::Opacity, point }).toPoint();
  }

  // A position in the plot away from the curve.
  QPoint Empty() const
  {
    return QPoint(int(this->Layout().axis.ToPixel(1000.0)), int(this->Layout().ToY(0.25)));
  }

  void Press(
    const QPoint& at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton)
  {
    QTest::mousePress(&this->editor, button, modifiers, at);
    this->button = button;
  }

  void MoveTo(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
  {
    QMouseEvent event(
      QEvent::MouseMove, at, this->editor.mapToGlobal(at), Qt::NoButton, this->button, modifiers);
    QApplication::sendEvent(&this->editor, &event);
  }

  void Release(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
  {
    QTest::mouseRelease(&this->editor, this->button, modifiers, at);
    this->button = Qt::NoButton;
  }

  // Drags through intermediate positions, as a hand does.
  void Drag(const QPoint& from, const QPoint& way, Qt::KeyboardModifiers modifiers = {},
    Qt::MouseButton with = Qt::LeftButton)
  {
    this->Press(from, modifiers, with);
    for (int i = 1; i <= 4; ++i)
    {
      this->MoveTo(from + way * i / 4, modifiers);
    }
    this->Release(from + way, modifiers);
  }

  void Wheel(const QPointF& at, int notches, Qt::KeyboardModifiers modifiers = {})
  {
    QWheelEvent event(at, this->editor.mapToGlobal(at.toPoint()), {}, { 0, 120 * notches },
      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&this->editor, &event);
  }

  template <class Widget>
  Widget* InPopover(const char* name) const
  {
    const auto* const popover = this->editor.findChild<QWidget*>("nodePopover");
    return popover ? popover->findChild<Widget*>(name) : nullptr;
  }

  SceneModel model;
  TransferFunctionEditor editor;
  Qt::MouseButton button = Qt::NoButton;
};

}

#endif
