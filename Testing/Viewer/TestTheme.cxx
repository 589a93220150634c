// Light and dark themes: applied at once, and remembered.

#include "Viewer/Theme.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPalette>
#include <QWidget>

#include <gtest/gtest.h>

#include <cmath>

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
  ASSERT_EQ(menu->actions().size(), 4);
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

namespace
{

// Relative luminance of a colour (WCAG 2.1).
double Luminance(const QColor& color)
{
  const auto linear = [](double part)
  { return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
    0.0722 * linear(color.blueF());
}

}

TEST(Theme, OfHighContrastIsEnhancedByTheWebsRules)
{
  QWidget window;
  const std::unique_ptr<QMenu> menu(NewThemeMenu(&window));
  menu->actions()[3]->trigger();
  EXPECT_EQ(ChosenTheme(), Theme::HighContrast);
  const QPalette palette = QApplication::palette();
  const std::pair<QPalette::ColorRole, QPalette::ColorRole> read[] = {
    { QPalette::WindowText, QPalette::Window }, { QPalette::Text, QPalette::Base },
    { QPalette::ButtonText, QPalette::Button }, { QPalette::ToolTipText, QPalette::ToolTipBase },
    { QPalette::HighlightedText, QPalette::Highlight }, { QPalette::Link, QPalette::Base },
    { QPalette::PlaceholderText, QPalette::Base }
  };
  for (const auto& [text, ground] : read)
  {
    const double bright = Luminance(palette.color(text));
    const double dark = Luminance(palette.color(ground));
    EXPECT_GE((std::max(bright, dark) + 0.05) / (std::min(bright, dark) + 0.05), 7.0) << int(text);
  }
  menu->actions()[0]->trigger();
}
