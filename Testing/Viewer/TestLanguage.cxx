// Every language that the program offers is spoken by its window.

#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"

#include <QCoreApplication>
#include <QMenuBar>

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

TEST_F(Speaking, KeepsTheChoice)
{
  ChooseLanguage("es");
  EXPECT_EQ(ChosenLanguage(), "es");
  ChooseLanguage({});
  EXPECT_TRUE(ChosenLanguage().isEmpty());
}
