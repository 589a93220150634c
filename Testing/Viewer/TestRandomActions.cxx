// Random actions in the whole window: clicks, drags, keys, menus, sliders, undo, and opening the
// scan again, while it may be busy. Whatever is done, a saved session reads back equal, undoing
// everything returns to the beginning, and VTK reports no error. In the end the window closes while
// it loads.
//
// VARIMARCH_RANDOM_ACTIONS is the number of actions, VARIMARCH_RANDOM_SEED the seed.

#include "Module/Dice.h"
#include "Scene/SceneFile.h"
#include "TorsoWindow.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"
#include "Viewer/View/SliceView.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QSpinBox>
#include <QTimer>

#include <fstream>

using namespace varimarch;

namespace
{

/// Gives up dialogs and menus that open while it exists, as the Escape key does.
class DialogsGivenUp
{
public:
  DialogsGivenUp()
  {
    QObject::connect(&this->timer, &QTimer::timeout,
      []
      {
        for (QWidget* const opened :
          { QApplication::activePopupWidget(), QApplication::activeModalWidget() })
        {
          if (opened)
          {
            QTest::keyClick(opened, Qt::Key_Escape);
          }
        }
      });
    this->timer.start(20);
  }

private:
  QTimer timer;
};

/// Resident memory of this process [MB].
double ResidentMegabytes()
{
  long pages = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return double(resident) * 4096.0 / 1e6;
}

std::string TextOf(const SceneModel* model)
{
  return SceneText(model->CurrentScene());
}

/// A user without a plan.
class Monkey
{
public:
  Monkey(MainWindow* window, const QString& scan, std::uint64_t seed)
    : window(window)
    , scan(scan)
    , dice(seed, 0)
  {
  }

  /// Does something, and returns its name.
  QString Act()
  {
    if (this->dice.Chance(0.03))
    {
      return this->Open();
    }
    switch (this->dice.Whole(0, 7))
    {
      case 0:
        return this->Drag();
      case 1:
        return this->Key();
      case 2:
        return this->Trigger();
      case 3:
        return this->Undo();
      case 4:
        return this->Resize();
      default:
        return this->Operate();
    }
  }

  /// Opens the scan again without waiting for it, and without work that a question would protect.
  QString Open()
  {
    this->window->Model()->History()->setIndex(0);
    this->window->Open(this->scan);
    return "open";
  }

private:
  template <class Widget>
  QList<Widget*> Usable() const
  {
    QList<Widget*> usable;
    for (Widget* const widget : this->window->findChildren<Widget*>())
    {
      if (widget->isVisible() && widget->isEnabled() && widget->width() > 4 && widget->height() > 4)
      {
        usable << widget;
      }
    }
    return usable;
  }

  QPoint PlaceIn(const QWidget* widget)
  {
    return { this->dice.Whole(0, widget->width() - 1), this->dice.Whole(0, widget->height() - 1) };
  }

  template <class Thing>
  Thing AnyOf(const QList<Thing>& things)
  {
    return things[this->dice.Whole(0, things.size() - 1)];
  }

  /// A widget that is dragged in: half of the time a picture or the editor.
  QWidget* Dragged()
  {
    QList<QWidget*> widgets = this->Usable<QWidget>();
    if (this->dice.Chance(0.5))
    {
      QList<QWidget*> views;
      for (QWidget* const widget : widgets)
      {
        if (qobject_cast<VolumeView*>(widget) || qobject_cast<SliceView*>(widget) ||
          qobject_cast<TransferFunctionEditor*>(widget))
        {
          views << widget;
        }
      }
      widgets = views.isEmpty() ? widgets : views;
    }
    return this->AnyOf(widgets);
  }

  QString Drag()
  {
    QPointer<QWidget> widget = this->Dragged();
    const Qt::MouseButton button = this->dice.OneOf<Qt::MouseButton>(
      { Qt::LeftButton, Qt::LeftButton, Qt::RightButton, Qt::MiddleButton });
    const Qt::KeyboardModifiers keys =
      this->dice.OneOf<Qt::KeyboardModifier>({ Qt::NoModifier, Qt::ShiftModifier });
    const QString name =
      QString("drag in %1 '%2'").arg(widget->metaObject()->className(), widget->objectName());
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

  QString Key()
  {
    const auto key = this->dice.OneOf<Qt::Key>(
      { Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Delete, Qt::Key_Tab,
        Qt::Key_Escape, Qt::Key_Home, Qt::Key_PageUp, Qt::Key_1, Qt::Key_Return, Qt::Key_Space });
    QWidget* const focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : this->window, key);
    return QString("key %1").arg(key, 0, 16);
  }

  /// Triggers an action of the menus, except those that end the program or open another scan.
  QString Trigger()
  {
    QList<QAction*> usable;
    for (QAction* const action : this->window->findChildren<QAction*>())
    {
      const bool leaves = action->menuRole() == QAction::QuitRole ||
        action->shortcut() == QKeySequence(QKeySequence::Quit) || action->text().contains("torso");
      if (action->isEnabled() && !action->menu() && !action->text().isEmpty() && !leaves)
      {
        usable << action;
      }
    }
    QAction* const action = this->AnyOf(usable);
    const QString name = "menu " + action->text();
    action->trigger();
    return name;
  }

  QString Undo()
  {
    QUndoStack* const history = this->window->Model()->History();
    for (int step = this->dice.Whole(0, 4); step >= 0; --step)
    {
      this->dice.Chance(0.5) ? history->undo() : history->redo();
    }
    return "undo and redo";
  }

  QString Resize()
  {
    this->window->resize(700 + this->dice.Whole(0, 499), 400 + this->dice.Whole(0, 299));
    return "resize";
  }

  QString Operate()
  {
    QList<QWidget*> controls;
    for (QWidget* const widget : this->Usable<QWidget>())
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
    const QString name =
      QString("%1 '%2'").arg(control->metaObject()->className()).arg(control->objectName());
    this->Set(control);
    return name;
  }

  void Set(QWidget* control)
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

  MainWindow* window;
  QString scan;
  Dice dice;
};

}

TEST_F(Window, SurvivesRandomActions)
{
  const long count = NumberFromEnvironment("VARIMARCH_RANDOM_ACTIONS", 150);
  const long seed = NumberFromEnvironment("VARIMARCH_RANDOM_SEED", 1);
  this->OpenTorso();
  std::string beginning = TextOf(this->Model());
  const QObject opening;
  QObject::connect(this->window.Loader(), &VolumeLoader::Loaded, &opening,
    [&] { beginning = TextOf(this->Model()); });
  const DialogsGivenUp dialogs;
  Monkey monkey(&this->window, this->Path("torso.vti"), seed);
  QStringList history;
  double earlyMegabytes = 0.0;
  for (long number = 1; number <= count; ++number)
  {
    history << monkey.Act();
    QTest::qWait(number % 7 == 0 ? 60 : 1);
    const auto place = [&]
    { return QString("seed %1, after: %2").arg(seed).arg(history.join("; ")).toStdString(); };
    ASSERT_TRUE(this->window.isVisible()) << place();
    ASSERT_TRUE(this->Model()->CurrentStudy()) << place();

    const std::string now = TextOf(this->Model());
    ASSERT_EQ(SceneText(SceneFromText(now, "session")), now) << place();
    // The last step is undone and repeated after every action, all steps after every 50th.
    QUndoStack* const steps = this->Model()->History();
    const int index = steps->index();
    steps->setIndex(number % 50 == 0 ? 0 : std::max(index - 1, 0));
    ASSERT_TRUE(steps->index() > 0 || TextOf(this->Model()) == beginning) << place();
    steps->setIndex(index);
    ASSERT_EQ(TextOf(this->Model()), now) << place();
    if (number == count / 2)
    {
      earlyMegabytes = ResidentMegabytes();
    }
  }
  EXPECT_LT(ResidentMegabytes(), earlyMegabytes + 150.0);
  monkey.Open();
  EXPECT_TRUE(this->window.close()) << "while it loads";
}
