#include "TaskHand.h"

#include "Viewer/MainWindow.h"
#include "Viewer/Panels/PresetGallery.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTest>

#include <vtkVariationFieldVolumeMapper.h>

#include <cmath>
#include <stdexcept>
#include <tuple>

namespace
{

constexpr double SecondsOfClick = 1.35 + 1.1 + 2 * 0.1;
constexpr double SecondsOfDrag = 1.35 + 2 * 1.1 + 2 * 0.1;
constexpr double SecondsOfKey = 0.28;

// Queued, since a timer rests while it waits for a dialog that an answer opens.
void AcceptName(QWidget* dialog, const QString& path)
{
  auto* const file = qobject_cast<QFileDialog*>(dialog);
  Await([&] { return file != nullptr; }, "another dialog than one for a file");
  auto* const name = file->findChild<QLineEdit*>("fileNameEdit");
  name->setText(path);
  QTest::keyClick(name, Qt::Key_Return);
}

}

void Await(const std::function<bool()>& isDone, const char* what)
{
  constexpr int MostMilliseconds = 600000; // others may want the machine too
  if (!QTest::qWaitFor(isDone, MostMilliseconds))
  {
    throw std::runtime_error(what);
  }
}

void AwaitPictures(varimarch::MainWindow& window)
{
  auto* const mapper =
    vtkVariationFieldVolumeMapper::SafeDownCast(window.CentralView()->Ours()->Pipeline()->Mapper());
  for (int wait = 0; wait < 3; ++wait)
  {
    QTest::qWait(500); // on a busy machine a change is drawn in the second one
    Await([&] { return mapper->GetAccumulatedPictures() > 0; }, "the volume is not drawn");
  }
  const auto* const presets =
    window.findChild<varimarch::PresetGallery*>()->findChild<QListWidget*>();
  const auto keys = [presets]
  {
    QList<qint64> found;
    for (int row = 0; row < presets->count(); ++row)
    {
      found.append(presets->item(row)->icon().cacheKey());
    }
    return found;
  };
  constexpr int MostMilliseconds = 3000; // between two pictures
  for (QList<qint64> before; presets->isVisible() && before != keys();)
  {
    before = keys();
    std::ignore = QTest::qWaitFor([&] { return before != keys(); }, MostMilliseconds);
  }
}

TaskHand::TaskHand()
{
  QObject::connect(&this->timer, &QTimer::timeout, [this] { this->Answer(); });
  this->timer.start(20);
}

void TaskHand::Click(QWidget* widget, const QPoint& place)
{
  ++this->clicks;
  QTest::mouseClick(widget, Qt::LeftButton, {}, place);
}

void TaskHand::Drag(QWidget* widget, const QPoint& from, const QPoint& to)
{
  ++this->drags;
  QTest::mousePress(widget, Qt::LeftButton, {}, from);
  for (int part = 1; part <= 4; ++part)
  {
    QMouseEvent move(
      QEvent::MouseMove, QPointF(from + (to - from) * part / 4), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(widget, &move);
  }
  QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

void TaskHand::ChooseFromMenu(QAction* entry)
{
  QMenu* menu = nullptr;
  for (QWidget* const widget : entry->associatedWidgets())
  {
    menu = qobject_cast<QMenu*>(widget) ? qobject_cast<QMenu*>(widget) : menu;
  }
  auto* const window = qobject_cast<QMainWindow*>(
    menu->window()->parentWidget() ? menu->parentWidget()->window() : menu->window());
  QMenuBar* const bar = window->menuBar();
  this->Click(bar, bar->actionGeometry(menu->menuAction()).center());
  Await([&] { return menu->isVisible(); }, "a menu does not open");
  this->Click(menu, menu->actionGeometry(entry).center());
}

void TaskHand::RaisePanel(QWidget* window, const QString& name)
{
  auto* const dock = window->findChild<QDockWidget*>(name);
  auto* const tabs = window->findChild<QTabBar*>("panelTabs");
  for (int i = 0; i < tabs->count(); ++i)
  {
    const QPoint place = tabs->tabRect(i).center();
    if (tabs->tabText(i) == dock->windowTitle() && tabs->visibleRegion().contains(place))
    {
      this->Click(tabs, place);
      QTest::qWait(50);
      return;
    }
  }
  throw std::runtime_error("the title of a panel is not in sight");
}

void TaskHand::PressKey(QWidget* window, Qt::Key key)
{
  QApplication::setActiveWindow(window); // shortcuts need it, also without a window manager
  QTest::keyClick(window, key);
  ++this->keys;
}

void TaskHand::Type(QWidget* field, const QString& text)
{
  this->Click(field);
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(field, text);
  QTest::keyClick(field, Qt::Key_Return);
  this->keys += text.size() + 2;
}

void TaskHand::Expect(std::function<void(QWidget*)> answer)
{
  this->answers.push_back(std::move(answer));
}

void TaskHand::ExpectFile(const QString& path)
{
  this->Expect(
    [this, path](QWidget* dialog)
    {
      this->clicks += 2;
      AcceptName(dialog, path);
    });
}

void TaskHand::ExpectNameToSave(const QString& path)
{
  this->Expect(
    [this, path](QWidget* dialog)
    {
      ++this->clicks;
      AcceptName(dialog, path);
    });
}

void TaskHand::ExpectToDiscard()
{
  this->Expect(
    [](QWidget* dialog)
    {
      if (auto* const box = qobject_cast<QMessageBox*>(dialog))
      {
        box->button(QMessageBox::Discard)->click();
      }
    });
}

// An answer can open the next dialog, during which this is called again.
void TaskHand::Answer()
{
  QWidget* const dialog = QApplication::activeModalWidget();
  if (dialog && dialog->isVisible() && !this->answers.empty())
  {
    const auto answer = this->answers.front();
    this->answers.pop_front();
    QTimer::singleShot(0, dialog, [answer, dialog] { answer(dialog); });
  }
}

double TaskHand::Seconds() const
{
  return this->clicks * SecondsOfClick + this->drags * SecondsOfDrag + this->keys * SecondsOfKey;
}

void TaskHand::Rest()
{
  this->clicks = 0;
  this->drags = 0;
  this->keys = 0;
}

QStringList MissingRows(const QString& path, const std::vector<Effort>& efforts)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    throw std::runtime_error(path.toStdString() + ": cannot be read");
  }
  const QString table = QString::fromUtf8(file.readAll());
  QStringList missing;
  for (const Effort& effort : efforts)
  {
    const QString row = QStringLiteral("| %1 | %2 | %3 |")
                          .arg(effort.task)
                          .arg(effort.clicks)
                          .arg(std::lround(effort.seconds));
    if (!table.contains(row))
    {
      missing.append(row);
    }
  }
  return missing;
}
