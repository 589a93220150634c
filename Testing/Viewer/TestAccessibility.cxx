// The window for people who cannot see it, or who use no mouse, or need large letters: each control
// has a name, keys reach it, and nothing is cut off in letters of twice the size.

#include "LabelledStudy.h"
#include "Module/Files/PhantomDicom.h"
#include "OverlaidStudy.h"
#include "TorsoWindow.h"
#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Archives/ArchiveWindow.h"
#include "Viewer/Archives/SendDialog.h"
#include "Viewer/CommandPalette.h"
#include "Viewer/Open/RawForm.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Open/TagsWindow.h"
#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/Studies/StudyListWindow.h"
#include "Viewer/TransferFunctionEditor/EditorInput.h"
#include "Viewer/View/PictureExport.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QSet>
#include <QSlider>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

using namespace varimarch;

namespace
{

/// Parts that Qt makes within its own widgets, which have names of their own.
bool IsPartOfAnother(const QWidget* widget)
{
  const QWidget* const parent = widget->parentWidget();
  return widget->objectName().startsWith("qt_") || widget->inherits("QDockWidgetTitleButton") ||
    qobject_cast<const QTabBar*>(parent) || qobject_cast<const QAbstractSpinBox*>(parent) ||
    qobject_cast<const QComboBox*>(parent) || qobject_cast<const QLineEdit*>(parent) ||
    qobject_cast<const QHeaderView*>(widget) || qobject_cast<const QAbstractItemView*>(parent) ||
    widget->inherits("QComboBoxListView") || widget->inherits("QComboBoxPrivateContainer") ||
    qobject_cast<const QMenuBar*>(parent) || qobject_cast<const QMenuBar*>(widget) ||
    widget->inherits("QTableCornerButton");
}

bool IsControl(const QWidget* widget)
{
  const bool isUsed = qobject_cast<const QAbstractButton*>(widget) ||
    qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
    qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
    qobject_cast<const QAbstractItemView*>(widget) || (widget->focusPolicy() & Qt::TabFocus);
  const bool isFrame = qobject_cast<const QAbstractScrollArea*>(widget) &&
    !qobject_cast<const QAbstractItemView*>(widget);
  const bool isBar = widget->inherits("QScrollBar") || widget->inherits("QTabBar") ||
    widget->inherits("QDialog") || qobject_cast<const QLabel*>(widget);
  return isUsed && !isFrame && !isBar && !IsPartOfAnother(widget);
}

std::string Description(const QWidget* widget)
{
  std::string description = widget->metaObject()->className();
  for (const QWidget* at = widget; at; at = at->parentWidget())
  {
    description += " in " + at->objectName().toStdString() + ":" + at->metaObject()->className();
  }
  return description;
}

void ExpectNames(const QWidget& window)
{
  int count = 0;
  for (QWidget* const widget : window.findChildren<QWidget*>())
  {
    if (IsControl(widget) && !widget->isHidden())
    {
      ++count;
      QAccessibleInterface* const told = QAccessible::queryAccessibleInterface(widget);
      EXPECT_TRUE(told && !told->text(QAccessible::Name).isEmpty()) << Description(widget);
    }
  }
  EXPECT_GT(count, 0);
}

/// True for buttons of commands that the menus or their keys give too, and for the list of
/// commands, through which the arrow keys of the line above it move.
bool HasOtherWay(const QWidget* widget)
{
  if (widget->parentWidget()->objectName() == "commandPalette")
  {
    return true;
  }
  const auto* const button = qobject_cast<const QToolButton*>(widget);
  return button && button->defaultAction() &&
    (!button->defaultAction()->shortcut().isEmpty() ||
      button->defaultAction()->associatedWidgets().size() > 1);
}

void ExpectReachedByKeys(const QWidget& window)
{
  for (QWidget* const widget : window.findChildren<QWidget*>())
  {
    if (IsControl(widget))
    {
      EXPECT_TRUE((widget->focusPolicy() & Qt::TabFocus) || HasOtherWay(widget))
        << Description(widget);
    }
  }
}

/// The widgets that have the keys one after another when Tab is pressed, until the first has them
/// again. Editors take Tab for each of their nodes.
QSet<QWidget*> ReachedByTab(MainWindow& window)
{
  QApplication::setActiveWindow(&window); // also without a window manager
  window.CentralView()->Ours()->setFocus();
  constexpr int MostPresses = 400;
  QWidget* const first = QApplication::focusWidget();
  QSet<QWidget*> reached;
  QWidget* at = first;
  for (int press = 0; at && press < MostPresses && (at != first || reached.size() < 2); ++press)
  {
    reached.insert(at);
    QTest::keyClick(at, Qt::Key_Tab);
    at = QApplication::focusWidget();
  }
  EXPECT_EQ(at, first) << "Tab stays at " << (at ? Description(at) : "nothing");
  return reached;
}

/// True for a button of a group through which the arrow keys move, one of which Tab has reached.
bool IsInReachedGroup(const QWidget* widget, const QSet<QWidget*>& reached)
{
  const auto* const button = qobject_cast<const QAbstractButton*>(widget);
  const QList<QAbstractButton*> group =
    button && button->group() ? button->group()->buttons() : QList<QAbstractButton*>();
  return std::any_of(
    group.begin(), group.end(), [&](QAbstractButton* of) { return reached.contains(of); });
}

/// False in a panel that lies below another one.
bool IsRaised(const QWidget* widget)
{
  for (; widget; widget = widget->parentWidget())
  {
    if (qobject_cast<const QDockWidget*>(widget) && widget->visibleRegion().isEmpty())
    {
      return false;
    }
  }
  return true;
}

class Accessible : public Window
{
protected:
  /// Fills all panels.
  void SetUp() override
  {
    this->OpenTorso();
    this->Model()->ShowLabels({ "labels.nrrd" }, LabelledStudy(), "labels");
    AddPet(*this->Model());
    this->Model()->Edit(ScenePart::Lights, "lights",
      [](Scene& scene)
      {
        scene.lights.resize(2);
        scene.lights[1].kind = LightKind::Positional;
      });
    this->Model()->Edit(ScenePart::Cuts, "cut",
      [](Scene& scene) {
        scene.cuts.planes.push_back({ { 0, 0, 0 }, { 1, 0, 0 } });
      });
    this->Model()->Edit(ScenePart::Measures, "measure",
      [](Scene& scene) {
        scene.measures.push_back(
          { MeasureKind::Distance, { { 0, 0, 0 }, { 30, 40, 0 } }, "aorta" });
      });
  }

  /// All dialogs of the program.
  std::vector<std::unique_ptr<QWidget>> Dialogs()
  {
    QFile bytes(this->Path("bare.raw"));
    EXPECT_TRUE(bytes.open(QIODevice::WriteOnly));
    bytes.write(QByteArray(4096, '\1'));
    bytes.close();
    std::vector<std::unique_ptr<QWidget>> dialogs;
    const auto add = [&](QWidget* dialog)
    {
      dialog->setAttribute(Qt::WA_DeleteOnClose, false);
      dialogs.emplace_back(dialog);
    };
    QWidget* const parent = &this->window;
    add(new ArchiveWindow(parent));
    add(new ArchiveForm({}, parent));
    add(new SendDialog(this->Model(), { 64, 64 }, parent));
    add(new CommandPalette(this->window.menuBar(), parent));
    add(new RawForm(this->Path("bare.raw"), parent));
    add(new SeriesPicker({ {}, {} }, parent));
    add(new TagsWindow({ this->Path("bare.raw").toStdString(), std::nullopt }, parent));
    add(new BenchmarkDialog(this->Model(), { 64, 64 }, parent));
    add(new StudyListWindow(this->Path("studies.sqlite"), parent));
    add(new NodePopover(
      this->Model()->CurrentScene().look, { NodeKind::Opacity, 0 }, "HU", 0, parent));
    add(new ExportDialog(this->Model(), { 64, 64 }, parent));
    return dialogs;
  }
};

/// Run with letters of twice the size on a screen of 1280x720, by CMakeLists.txt.
class LargeText : public Window
{
};

}

TEST_F(Accessible, WindowHasANameForEveryControl)
{
  ExpectNames(this->window);
}

TEST_F(Accessible, DialogsHaveANameForEveryControl)
{
  for (const auto& dialog : this->Dialogs())
  {
    ExpectNames(*dialog);
  }
}

TEST_F(Accessible, WindowAndDialogsAreReachedByKeys)
{
  ExpectReachedByKeys(this->window);
  for (const auto& dialog : this->Dialogs())
  {
    ExpectReachedByKeys(*dialog);
  }
}

// Tab goes through the window, and back to where it began.
TEST_F(Accessible, TabReachesEveryControlOfEveryPanel)
{
  auto* const tabs = this->window.findChild<QTabBar*>("panelTabs");
  for (int panel = 0; panel < tabs->count(); ++panel)
  {
    tabs->setCurrentIndex(panel);
    QTest::qWait(50);
    const QSet<QWidget*> reached = ReachedByTab(this->window);
    for (QWidget* const widget : this->window.findChildren<QWidget*>())
    {
      const bool isInSight = widget->isVisible() && widget->isEnabled() && IsRaised(widget);
      if (IsControl(widget) && isInSight && !HasOtherWay(widget))
      {
        EXPECT_TRUE(reached.contains(widget) || IsInReachedGroup(widget, reached))
          << Description(widget) << ", with the panel " << tabs->tabText(panel).toStdString();
      }
    }
  }
}

TEST_F(LargeText, IsNotCutOff)
{
  ASSERT_GT(QFontMetrics(QApplication::font()).height(), 24) << "the letters are not large";
  this->window.resize(1280, 690);
  this->OpenTorso();
  this->Model()->ShowLabels({ "labels.nrrd" }, LabelledStudy(), "labels");
  for (QDockWidget* const dock : this->window.findChildren<QDockWidget*>())
  {
    dock->raise();
    QTest::qWait(100);
    EXPECT_LE(this->window.width(), 1280) << dock->objectName().toStdString();
    EXPECT_LE(this->window.height(), 720) << dock->objectName().toStdString();
    for (QWidget* const widget : dock->findChildren<QWidget*>())
    {
      const bool isToRead = qobject_cast<QLabel*>(widget) || qobject_cast<QAbstractButton*>(widget);
      if (isToRead && widget->isVisible() && !IsPartOfAnother(widget))
      {
        EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << Description(widget);
        EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << Description(widget);
      }
    }
    // Panels scroll to what does not fit; the view along a curve fits always.
    if (auto* const scroll = dock->findChild<QScrollArea*>())
    {
      EXPECT_GE(scroll->widget()->width(), scroll->widget()->minimumSizeHint().width());
    }
  }
  if (qEnvironmentVariableIsSet("VARIMARCH_PICTURES"))
  {
    this->window.grab().save(qEnvironmentVariable("VARIMARCH_PICTURES") + "/large-text.png");
  }
}
