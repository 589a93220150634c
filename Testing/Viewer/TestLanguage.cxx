// The window is translated into every language that the program offers.

#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QTabBar>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

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

// Narrow panels scroll their titles.
TEST_F(Speaking, ShowsTheTitlesOfPanelsInFull)
{
  for (const Language& language : Languages())
  {
    Speak(language.code, QCoreApplication::instance());
    MainWindow window;
    window.resize(1280, 720);
    window.show();
    window.resizeDocks({ window.findChild<QDockWidget*>("look") }, { 100 }, Qt::Horizontal);
    QTest::qWait(100);
    const auto* const tabs = window.findChild<QTabBar*>();
    ASSERT_TRUE(tabs);
    ASSERT_EQ(tabs->count(), 4);
    for (int i = 0; i < tabs->count(); ++i)
    {
      const int words = tabs->fontMetrics().horizontalAdvance(tabs->tabText(i));
      EXPECT_GT(tabs->tabRect(i).width(), words) << tabs->tabText(i).toStdString();
      EXPECT_EQ(tabs->tabToolTip(i), tabs->tabText(i));
    }
  }
}

TEST_F(Speaking, KeepsTheChoice)
{
  ChooseLanguage("es");
  EXPECT_EQ(ChosenLanguage(), "es");
  ChooseLanguage({});
  EXPECT_TRUE(ChosenLanguage().isEmpty());
}
