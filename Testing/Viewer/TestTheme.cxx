// Light and dark themes: applied at once, and remembered.

#include "Viewer/Theme.h"
#include "Viewer/Tools/ToolIcons.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QMenu>
#include <QPalette>
#include <QTabBar>
#include <QWidget>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

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

// An empty box to check is only its frame.
TEST(Theme, ShowsBoxesToCheck)
{
  for (const Theme theme : { Theme::Light, Theme::Dark, Theme::HighContrast })
  {
    ApplyTheme(theme);
    QCheckBox box;
    const QImage image = box.grab().toImage();
    const double ground = Luminance(box.palette().color(QPalette::Window));
    double most = 1.0;
    for (int i = 0; i < image.width() * image.height(); ++i)
    {
      const double here = Luminance(image.pixelColor(i % image.width(), i / image.width()));
      most = std::max(most, (std::max(here, ground) + 0.05) / (std::min(here, ground) + 0.05));
    }
    EXPECT_GT(most, 3.0) << int(theme) << ": the contrast that WCAG 2.1 asks of controls";
  }
  ApplyTheme(Theme::System);
}

TEST(Theme, MarksTheTitleInFront)
{
  ApplyTheme(Theme::Dark);
  QTabBar tabs;
  tabs.addTab("front");
  tabs.addTab("behind");
  tabs.resize(tabs.sizeHint());
  const QImage image = tabs.grab().toImage();
  const auto blueness = [&](int tab)
  {
    const QRect place = tabs.tabRect(tab);
    const QColor color = image.pixelColor(place.left() + 6, place.center().y());
    return color.blue() - color.red();
  };
  EXPECT_GT(blueness(0), blueness(1) + 20);
  ApplyTheme(Theme::System);
}

namespace
{

// The colour of the pixel of an icon that covers most.
QColor ColorOf(const QIcon& icon, QIcon::Mode mode)
{
  const QImage image = icon.pixmap(48, 48, mode).toImage();
  QColor color(0, 0, 0, 0);
  for (int i = 0; i < image.width() * image.height(); ++i)
  {
    const QColor here = image.pixelColor(i % image.width(), i / image.width());
    color = here.alpha() > color.alpha() ? here : color;
  }
  return color;
}

}

TEST(ToolIcons, HaveTheColourOfTheWordsInEachTheme)
{
  const std::vector<LeftButton> buttons = { LeftButton::Turn, LeftButton::Walk,
    LeftButton::Brightness, LeftButton::Distance, LeftButton::Angle, LeftButton::Box,
    LeftButton::CutOut, LeftButton::KeepOnly, LeftButton::Text };
  for (const Theme theme : { Theme::Light, Theme::Dark, Theme::HighContrast, Theme::System })
  {
    ApplyTheme(theme);
    const QPalette palette = QApplication::palette();
    std::vector<QImage> seen;
    for (const LeftButton button : buttons)
    {
      const QIcon icon = IconOf(button);
      EXPECT_EQ(ColorOf(icon, QIcon::Normal), palette.color(QPalette::ButtonText)) << int(button);
      EXPECT_EQ(
        ColorOf(icon, QIcon::Disabled), palette.color(QPalette::Disabled, QPalette::ButtonText));
      const QImage image = icon.pixmap(24, 24).toImage();
      EXPECT_EQ(std::count(seen.begin(), seen.end(), image), 0) << "each is another";
      seen.push_back(image);
    }
  }
}
