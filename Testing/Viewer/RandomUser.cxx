#include "RandomUser.h"

#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"
#include "Viewer/View/CurvedView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/VolumeView.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QPointer>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>

namespace varimarch
{

namespace
{

template <class Widget>
QList<Widget*> UsableIn(const MainWindow* window)
{
  QList<Widget*> usable;
  for (Widget* const widget : window->findChildren<Widget*>())
  {
    if (widget->isVisible() && widget->isEnabled() && widget->width() > 4 && widget->height() > 4)
    {
      usable << widget;
    }
  }
  return usable;
}

QString NameOf(const QObject* object)
{
  return QString("%1 '%2'").arg(object->metaObject()->className(), object->objectName());
}

/// True for actions that end the program or open a scan of the list of recent ones.
bool Leaves(const QAction* action, const RandomFiles& files)
{
  const QString text = action->text();
  return action->menuRole() == QAction::QuitRole ||
    action->shortcut() == QKeySequence(QKeySequence::Quit) ||
    text.contains(QFileInfo(files.scan).fileName()) ||
    text.contains(QFileInfo(files.times).fileName());
}

}

RandomUser::RandomUser(MainWindow* window, const RandomFiles& files, std::uint64_t seed)
  : window(window)
  , files(files)
  , dice(seed, 0)
{
}

QString RandomUser::Act()
{
  if (this->dice.Chance(0.04))
  {
    return this->OpenSomething();
  }
  using Action = QString (RandomUser::*)();
  const auto action = this->dice.OneOf<Action>({ &RandomUser::Drag, &RandomUser::Turn,
    &RandomUser::Annotate, &RandomUser::Key, &RandomUser::Trigger, &RandomUser::Undo,
    &RandomUser::Resize, &RandomUser::RaisePanel, &RandomUser::ChooseItem, &RandomUser::Operate,
    &RandomUser::Operate, &RandomUser::Operate, &RandomUser::Operate });
  return (this->*action)();
}

QString RandomUser::OpenSomething()
{
  switch (this->dice.Whole(0, 3))
  {
    case 0:
      this->window->AddScan(this->files.further);
      return "add a scan";
    case 1:
      return this->Drop();
    default:
      return this->Open();
  }
}

QString RandomUser::Open()
{
  this->window->Model()->History()->setIndex(0);
  const bool hasTimes = this->dice.Chance(0.5);
  this->window->Open(hasTimes ? this->files.times : this->files.scan);
  return hasTimes ? "open times" : "open";
}

QString RandomUser::Drop()
{
  QMimeData data;
  data.setUrls({ QUrl::fromLocalFile(this->files.segmentation) });
  QDropEvent drop({ 10.0, 10.0 }, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(this->window, &drop);
  return "drop a segmentation";
}

QPoint RandomUser::PlaceIn(const QWidget* widget)
{
  return { this->dice.Whole(0, widget->width() - 1), this->dice.Whole(0, widget->height() - 1) };
}

template <class Thing>
Thing RandomUser::AnyOf(const QList<Thing>& things)
{
  return things[this->dice.Whole(0, things.size() - 1)];
}

/// Pictures and the editor, or the window if there are none.
QList<QWidget*> RandomUser::Views() const
{
  QList<QWidget*> views;
  for (QWidget* const widget : UsableIn<QWidget>(this->window))
  {
    if (qobject_cast<VolumeView*>(widget) || qobject_cast<SliceView*>(widget) ||
      qobject_cast<CurvedView*>(widget) || qobject_cast<TransferFunctionEditor*>(widget))
    {
      views << widget;
    }
  }
  return views.isEmpty() ? QList<QWidget*>{ this->window } : views;
}

/// A widget that is dragged in: half of the time a picture or the editor.
QWidget* RandomUser::Dragged()
{
  return this->AnyOf(this->dice.Chance(0.5) ? this->Views() : UsableIn<QWidget>(this->window));
}

QString RandomUser::Drag()
{
  return this->DragIn(this->Dragged());
}

QString RandomUser::DragIn(QWidget* dragged)
{
  const QPointer<QWidget> widget = dragged;
  const auto button = this->dice.OneOf<Qt::MouseButton>(
    { Qt::LeftButton, Qt::LeftButton, Qt::RightButton, Qt::MiddleButton });
  const Qt::KeyboardModifiers keys = this->dice.OneOf<Qt::KeyboardModifier>(
    { Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier });
  const QString name = "drag in " + NameOf(widget);
  if (this->dice.Chance(0.1))
  {
    QTest::mouseDClick(widget, button, keys, this->PlaceIn(widget));
    return "double " + name;
  }
  QTest::mousePress(widget, button, keys, this->PlaceIn(widget));
  for (int move = this->dice.Whole(0, 3); move > 0 && widget; --move)
  {
    const QPoint place = this->PlaceIn(widget);
    QMouseEvent moved(
      QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button, keys);
    QApplication::sendEvent(widget, &moved);
  }
  if (widget)
  {
    QTest::mouseRelease(widget, button, keys, this->PlaceIn(widget));
  }
  return name;
}

QString RandomUser::Turn()
{
  QWidget* const view = this->AnyOf(this->Views());
  const QPoint place = this->PlaceIn(view);
  const int steps = this->dice.Whole(1, 3) * (this->dice.Chance(0.5) ? 120 : -120);
  const Qt::KeyboardModifiers keys = this->dice.OneOf<Qt::KeyboardModifier>(
    { Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier });
  QWheelEvent wheel(place, view->mapToGlobal(place), {}, { 0, steps }, Qt::NoButton, keys,
    Qt::NoScrollPhase, false);
  const QString name = "wheel in " + NameOf(view);
  QApplication::sendEvent(view, &wheel);
  return name;
}

/// Takes a tool of the left button, and uses it in a view.
QString RandomUser::Annotate()
{
  const auto* const bar = this->window->findChild<QToolBar*>("leftButton");
  QAction* const tool = this->AnyOf(bar->actions().first()->actionGroup()->actions());
  tool->trigger();
  return tool->text() + ", " + this->DragIn(this->AnyOf(this->Views()));
}

/// Presses a key, which may be a shortcut, or types a word if a line waits for one.
QString RandomUser::Key()
{
  QWidget* const focus = QApplication::focusWidget();
  QWidget* const receiver = focus ? focus : this->window;
  if (qobject_cast<QLineEdit*>(receiver) && this->dice.Chance(0.5))
  {
    return this->Type(receiver);
  }
  const auto key = this->dice.OneOf<Qt::Key>({ Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,
    Qt::Key_Down, Qt::Key_Delete, Qt::Key_Tab, Qt::Key_Escape, Qt::Key_Home, Qt::Key_PageUp,
    Qt::Key_1, Qt::Key_Return, Qt::Key_Space, Qt::Key_P, Qt::Key_Comma, Qt::Key_Period });
  QTest::keyClick(receiver, key);
  return QString("key %1").arg(key, 0, 16);
}

QString RandomUser::Type(QWidget* line)
{
  const auto word = this->dice.OneOf<QString>({ "a", "12", "-1e9", "node 3", "Milz, groß" });
  QTest::keyClicks(line, word);
  QTest::keyClick(line, Qt::Key_Return);
  return "type " + word;
}

/// Triggers an action of the menus.
QString RandomUser::Trigger()
{
  QList<QAction*> usable;
  for (QAction* const action : this->window->findChildren<QAction*>())
  {
    if (action->isEnabled() && !action->menu() && !action->text().isEmpty() &&
      !Leaves(action, this->files))
    {
      usable << action;
    }
  }
  QAction* const action = this->AnyOf(usable);
  const QString name = "menu " + action->text();
  action->trigger();
  return name;
}

QString RandomUser::Undo()
{
  QUndoStack* const history = this->window->Model()->History();
  for (int step = this->dice.Whole(0, 4); step >= 0; --step)
  {
    this->dice.Chance(0.5) ? history->undo() : history->redo();
  }
  return "undo and redo";
}

QString RandomUser::Resize()
{
  this->window->resize(700 + this->dice.Whole(0, 499), 400 + this->dice.Whole(0, 299));
  return "resize";
}

QString RandomUser::RaisePanel()
{
  QDockWidget* const panel = this->AnyOf(this->window->findChildren<QDockWidget*>());
  panel->show();
  panel->raise();
  return "raise " + panel->objectName();
}

/// Clicks an item of a list or table, most often its box, or edits it.
QString RandomUser::ChooseItem()
{
  QList<QAbstractItemView*> lists = UsableIn<QAbstractItemView>(this->window);
  const auto isEmpty = [](QAbstractItemView* list)
  { return list->model()->rowCount() * list->model()->columnCount() == 0; };
  lists.erase(std::remove_if(lists.begin(), lists.end(), isEmpty), lists.end());
  if (lists.isEmpty())
  {
    return "no list";
  }
  QAbstractItemView* const list = this->AnyOf(lists);
  const QAbstractItemModel* const model = list->model();
  const QModelIndex item = model->index(
    this->dice.Whole(0, model->rowCount() - 1), this->dice.Whole(0, model->columnCount() - 1));
  list->scrollTo(item);
  const QRect place = list->visualRect(item);
  const QString name = QString("row %1 of ").arg(item.row()) + NameOf(list);
  const QPoint middle = place.center();
  const QPoint box(place.left() + 8, middle.y());
  if (this->dice.Chance(0.2))
  {
    QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, middle);
    return "edit " + name;
  }
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, this->dice.Chance(0.6) ? box : middle);
  return name;
}

QString RandomUser::Operate()
{
  QList<QWidget*> controls;
  for (QWidget* const widget : UsableIn<QWidget>(this->window))
  {
    if (qobject_cast<QAbstractSlider*>(widget) || qobject_cast<QSpinBox*>(widget) ||
      qobject_cast<QDoubleSpinBox*>(widget) || qobject_cast<QComboBox*>(widget) ||
      qobject_cast<QAbstractButton*>(widget))
    {
      controls << widget;
    }
  }
  if (controls.isEmpty())
  {
    return "nothing to operate";
  }
  QWidget* const control = this->AnyOf(controls);
  const QString name = NameOf(control);
  this->Set(control);
  return name;
}

void RandomUser::Set(QWidget* control)
{
  const double part = this->dice.Between(0.0, 1.0);
  if (auto* const slider = qobject_cast<QAbstractSlider*>(control))
  {
    slider->setValue(slider->minimum() + int(part * (slider->maximum() - slider->minimum())));
  }
  else if (auto* const whole = qobject_cast<QSpinBox*>(control))
  {
    whole->setValue(whole->minimum() + int(part * (whole->maximum() - whole->minimum())));
  }
  else if (auto* const number = qobject_cast<QDoubleSpinBox*>(control))
  {
    number->setValue(number->minimum() + part * (number->maximum() - number->minimum()));
  }
  else if (auto* const choice = qobject_cast<QComboBox*>(control))
  {
    choice->setCurrentIndex(this->dice.Whole(0, std::max(choice->count(), 1) - 1));
  }
  else if (auto* const button = qobject_cast<QAbstractButton*>(control))
  {
    QTest::mouseClick(button, Qt::LeftButton);
  }
}

}
