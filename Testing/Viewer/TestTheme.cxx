// Light and dark themes: applied at once, and remembered.

#include "Viewer/Theme.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPalette>
#include <QWidget>

#include <gtest/gtest.h>

#include <memory>

using namespace varimarch;

namespace
{

double Contrast(QPalette::ColorRole text, QPalette::ColorRole ground)
{
  const QPalette palette = QApplication::palette();
  return palette.color(text).lightnessF() - palette.color(ground).lightnessF();
}

}

TEST(Theme, IsAppliedRememberedAndReverted)
{
  QWidget window;
  const std::unique_ptr<QMenu> menu(NewThemeMenu(&window));
  ASSERT_EQ(menu->actions().size(), 3);
  EXPECT_TRUE(menu->actions()[0]->isChecked()) << "the default is the desktop's theme";
  const QColor before = QApplication::palette().color(QPalette::Window);

  menu->actions()[2]->trigger();
  EXPECT_EQ(ChosenTheme(), Theme::Dark);
  const std::pair<QPalette::ColorRole, QPalette::ColorRole> read[] = {
    { QPalette::WindowText, QPalette::Window }, { QPalette::Text, QPalette::Base },
    { QPalette::ButtonText, QPalette::Button }, { QPalette::ToolTipText, QPalette::ToolTipBase }
  };
  for (const auto& [text, ground] : read)
  {
    EXPECT_GT(Contrast(text, ground), 0.5) << "light on dark";
  }
  menu->actions()[1]->trigger();
  EXPECT_EQ(ChosenTheme(), Theme::Light);
  EXPECT_LT(Contrast(QPalette::WindowText, QPalette::Window), -0.5);

  menu->actions()[0]->trigger();
  EXPECT_EQ(ChosenTheme(), Theme::System);
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), before);
}
