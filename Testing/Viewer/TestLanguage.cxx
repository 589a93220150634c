// The window is translated into every language that the program offers.

#include "LabelledStudy.h"
#include "OverlaidStudy.h"
#include "Scene/Json/SceneFile.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Panels/ViewBars.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>

using namespace varimarch;

namespace
{

// Text that identifies a widget in a failure message.
std::string Words(const QWidget* widget)
{
  const QVariant text = widget->property("text");
  return (text.isValid() ? text.toString() : widget->accessibleName()).toStdString();
}

void ExpectLegible(const MainWindow& window, const std::string& language)
{
  int seen = 0;
  for (QWidget* const widget : window.findChildren<QWidget*>())
  {
    const bool isToRead = qobject_cast<QLabel*>(widget) || qobject_cast<QAbstractButton*>(widget) ||
      qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
      qobject_cast<QSlider*>(widget);
    // Qt draws these smaller than they ask for: buttons of docks, and arrows beside tabs.
    const bool isOfQt =
      widget->inherits("QDockWidgetTitleButton") || qobject_cast<QTabBar*>(widget->parentWidget());
    if (!isToRead || isOfQt || !widget->isVisible() || widget->visibleRegion().isEmpty())
    {
      continue;
    }
    ++seen;
    const std::string what =
      language + ": " + widget->metaObject()->className() + (' ' + Words(widget));
    EXPECT_EQ(widget->visibleRegion().boundingRect().width(), widget->width()) << what;
    EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << what;
    EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << what;
  }
  EXPECT_GT(seen, 15);
}

class Speaking : public testing::Test
{
protected:
  ~Speaking() override { Speak("en", QCoreApplication::instance()); }

  QString FirstMenuIn(const QString& language)
  {
    Speak(language, QCoreApplication::instance());
    MainWindow window;
    return window.menuBar()->actions().first()->text();
  }
};

}

TEST_F(Speaking, TranslatesTheMenus)
{
  EXPECT_EQ(this->FirstMenuIn("de"), "&Datei");
  EXPECT_EQ(this->FirstMenuIn("es"), "&Archivo");
  EXPECT_EQ(this->FirstMenuIn("en"), "&File");
}

TEST_F(Speaking, TranslatesStandardButtons)
{
  Speak("de", QCoreApplication::instance());
  const QDialogButtonBox buttons(QDialogButtonBox::Cancel);
  EXPECT_EQ(buttons.button(QDialogButtonBox::Cancel)->text(), "Abbrechen")
    << "the package qttranslations5-l10n is missing";
}

TEST_F(Speaking, ShowsTheTitlesOfAllPanels)
{
  for (const Language& language : Languages())
  {
    Speak(language.code, QCoreApplication::instance());
    MainWindow window;
    window.resize(1280, 720);
    window.show();
    QTest::qWait(100);
    auto* const tabs = window.findChild<QTabBar*>("panelTabs");
    ASSERT_TRUE(tabs);
    ASSERT_EQ(tabs->count(), 7);
    for (int i = 0; i < tabs->count(); ++i)
    {
      const std::string title = (language.code + ": " + tabs->tabText(i)).toStdString();
      const int words = tabs->fontMetrics().horizontalAdvance(tabs->tabText(i));
      EXPECT_GT(tabs->tabRect(i).width(), words) << title;
      EXPECT_TRUE((QRegion(tabs->tabRect(i)) - tabs->visibleRegion()).isEmpty()) << title;
      QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
      EXPECT_EQ(tabs->currentIndex(), i);
      const auto panels = window.findChildren<QDockWidget*>();
      const bool isShown = std::any_of(panels.begin(), panels.end(),
        [&](const QDockWidget* panel)
        { return panel->windowTitle() == tabs->tabText(i) && !panel->visibleRegion().isEmpty(); });
      EXPECT_TRUE(isShown) << title;
    }
  }
}

// Menus open by Alt and a letter, and a letter that stands for two entries opens neither.
TEST_F(Speaking, GivesEveryEntryOfAMenuALetterOfItsOwn)
{
  for (const Language& language : Languages())
  {
    Speak(language.code, QCoreApplication::instance());
    MainWindow window;
    QList<QWidget*> menus{ window.menuBar() };
    for (QMenu* const menu : window.menuBar()->findChildren<QMenu*>())
    {
      menus.append(menu);
    }
    for (const QWidget* const menu : menus)
    {
      QMap<QString, QString> taken;
      for (const QAction* const action : menu->actions())
      {
        const QString letter = QKeySequence::mnemonic(action->text()).toString();
        EXPECT_TRUE(letter.isEmpty() || !taken.contains(letter))
          << language.code.toStdString() << ": " << action->text().toStdString() << " and "
          << taken[letter].toStdString();
        taken[letter] = action->text();
      }
    }
  }
}

// At the smallest supported window size, everything is legible and reachable.
TEST_F(Speaking, FitsASmallScreen)
{
  for (const Language& language : Languages())
  {
    Speak(language.code, QCoreApplication::instance());
    MainWindow window;
    window.resize(1280, 720);
    window.show();
    window.Model()->Open(ProceduralSource(), SmallStudy());
    window.Model()->ShowLabels({ "labels.nrrd" }, LabelledStudy(), "labels");
    AddPet(*window.Model());
    for (const char* const name : { "look", "lights", "cuts", "measures", "volumes", "segments" })
    {
      window.findChild<QDockWidget*>(name)->raise();
      QTest::qWait(100);
      EXPECT_EQ(window.size(), QSize(1280, 720)) << "the window had to grow for " << name;
      ExpectLegible(window, language.code.toStdString());
      const auto* const scroll = window.findChild<QDockWidget*>(name)->findChild<QScrollArea*>();
      EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0)
        << language.code.toStdString() << ": " << name << " is too wide";
    }
  }
}

TEST_F(Speaking, WritesNumbersAsTheLanguageDoesAndFilesAsInC)
{
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  Speak("de", QCoreApplication::instance());
  EXPECT_STREQ(std::localeconv()->decimal_point, ".") << "readers and writers of files";
  SceneModel model;
  model.Open(ProceduralSource(), SmallStudy());
  model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene) {
      scene.measures.push_back({ MeasureKind::Distance, { { 0, 0, 0 }, { 1234.5, 0, 0 } } });
    });
  SlabBar bar(&model);
  model.Edit(ScenePart::Slices, "slab", [](Scene& scene) { scene.slices.slabMm = 12.5; });
  EXPECT_EQ(bar.findChild<QDoubleSpinBox*>()->text(), "12,5 mm");
  const MeasureTexts texts(model.CurrentScene(), *model.CurrentStudy());
  EXPECT_EQ(texts.values[0], "1.234,5 mm");
  EXPECT_NE(SceneText(model.CurrentScene()).find("1234.5"), std::string::npos);
}

TEST_F(Speaking, KeepsTheChoice)
{
  ChooseLanguage("es");
  EXPECT_EQ(ChosenLanguage(), "es");
  ChooseLanguage({});
  EXPECT_TRUE(ChosenLanguage().isEmpty());
}
