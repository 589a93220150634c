#include "Viewer/Theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOptionButton>

#include <algorithm>
#include <map>
#include <utility>

namespace varimarch
{

namespace
{

const char* const Key = "window/theme";

/// The colours that a palette is made of.
struct ThemeColors
{
  QColor button;
  QColor window;
  QColor base; ///< behind texts and lists
  QColor text;
  QColor faint; ///< text that is disabled, or a hint
  QColor highlight;
  QColor highlightedText;
  QColor link;
};

// Buttons are lighter than the window.
const ThemeColors DarkColors = { { 62, 64, 69 }, { 45, 47, 51 }, { 30, 31, 34 }, { 228, 228, 228 },
  { 140, 140, 140 }, { 52, 120, 190 }, { 255, 255, 255 }, { 110, 180, 250 } };

// All texts that can be used have a contrast of at least 7 to 1, which WCAG 2.1 calls enhanced.
const ThemeColors HighContrastColors = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 255, 255, 255 },
  { 170, 170, 170 }, { 255, 225, 0 }, { 0, 0, 0 }, { 255, 225, 0 } };

QPalette PaletteOf(const ThemeColors& colors)
{
  QPalette palette(colors.button, colors.window);
  palette.setColor(QPalette::Base, colors.base);
  palette.setColor(QPalette::AlternateBase, colors.window);
  palette.setColor(QPalette::ToolTipBase, colors.base);
  palette.setColor(QPalette::PlaceholderText, colors.faint);
  palette.setColor(QPalette::Highlight, colors.highlight);
  palette.setColor(QPalette::HighlightedText, colors.highlightedText);
  palette.setColor(QPalette::Link, colors.link);
  for (const QPalette::ColorRole role :
    { QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText })
  {
    palette.setColor(role, colors.text);
    palette.setColor(QPalette::Disabled, role, colors.faint);
  }
  palette.setColor(QPalette::BrightText, Qt::white);
  return palette;
}

// Fusion draws frames by these roles, which are dark on black otherwise.
QPalette HighContrastPalette()
{
  QPalette palette = PaletteOf(HighContrastColors);
  for (const QPalette::ColorRole role :
    { QPalette::Light, QPalette::Midlight, QPalette::Mid, QPalette::Dark })
  {
    palette.setColor(role, HighContrastColors.faint);
  }
  return palette;
}

// Buttons that are on, such as the chosen tool, and the title of the panel in front have a tint of
// the highlight. Fusion only darkens them, which is hard to see in a dark window, as are the frames
// of its boxes to check.
class TintedStyle : public QProxyStyle
{
public:
  TintedStyle()
    : QProxyStyle(QStyleFactory::create("Fusion"))
  {
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const override
  {
    const bool isOn = element == PE_PanelButtonCommand && (option->state & State_On);
    const auto* const button = qstyleoption_cast<const QStyleOptionButton*>(option);
    if (isOn && button)
    {
      const QStyleOptionButton tinted = Tinted(*button);
      QProxyStyle::drawPrimitive(element, &tinted, painter, widget);
    }
    else if (isOn)
    {
      const QStyleOption tinted = Tinted(*option); // a tool button has no option of its own
      QProxyStyle::drawPrimitive(element, &tinted, painter, widget);
    }
    else if (button && (element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton))
    {
      const QStyleOptionButton framed = Framed(*button);
      QProxyStyle::drawPrimitive(element, &framed, painter, widget);
    }
    else
    {
      QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const override
  {
    const auto* const tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    if (element == CE_TabBarTabShape && tab && (option->state & State_Selected))
    {
      const QStyleOptionTab tinted = Tinted(*tab, QPalette::Window);
      QProxyStyle::drawControl(element, &tinted, painter, widget);
      return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
  }

  // Qt's icons on buttons of dialogs are black, which is hard to see on dark buttons.
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
    QStyleHintReturn* found) const override
  {
    return hint == SH_DialogButtonBox_ButtonsHaveIcons
      ? 0
      : QProxyStyle::styleHint(hint, option, widget, found);
  }

private:
  // The frame lies half way between the window and its letters.
  static QStyleOptionButton Framed(QStyleOptionButton option)
  {
    constexpr int Darkened = 140; // Fusion's colour of a frame is the window's, darker by this [%]
    const QPalette& palette = option.palette;
    const QColor frame =
      Mixed(palette.color(QPalette::Window), palette.color(QPalette::WindowText), 0.5);
    option.palette.setColor(QPalette::Window, frame.lighter(Darkened));
    return option;
  }

  template <class Option>
  static Option Tinted(Option option, QPalette::ColorRole role = QPalette::Button)
  {
    constexpr double Part = 0.35;
    const QPalette& palette = option.palette;
    option.palette.setColor(
      role, Mixed(palette.color(role), palette.color(QPalette::Highlight), Part));
    return option;
  }

  static QColor Mixed(const QColor& plain, const QColor& full, double part)
  {
    const auto mixed = [part](double a, double b) { return a + part * (b - a); };
    return QColor::fromRgbF(mixed(plain.redF(), full.redF()), mixed(plain.greenF(), full.greenF()),
      mixed(plain.blueF(), full.blueF()));
  }
};

/// A theme by its name in the settings.
const std::map<Theme, const char*>& ThemeNames()
{
  static const std::map<Theme, const char*> names = { { Theme::System, "system" },
    { Theme::Light, "light" }, { Theme::Dark, "dark" }, { Theme::HighContrast, "contrast" } };
  return names;
}

}

Theme ChosenTheme()
{
  const QString chosen = QSettings().value(Key).toString();
  const auto found = std::find_if(ThemeNames().begin(), ThemeNames().end(),
    [&](const auto& named) { return chosen == named.second; });
  return found == ThemeNames().end() ? Theme::System : found->first;
}

void ApplyTheme(Theme theme)
{
  // Icons then have all the pixels of a fine screen.
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  // Remember the desktop's style to return to it.
  static const QString systemStyle = QApplication::style()->objectName();
  if (theme == Theme::System)
  {
    QApplication::setStyle(systemStyle);
    QApplication::setPalette(QPalette());
    return;
  }
  QStyle* const fusion = new TintedStyle; // owned by the application
  QApplication::setStyle(fusion);
  QApplication::setPalette(theme == Theme::Dark ? PaletteOf(DarkColors)
      : theme == Theme::HighContrast            ? HighContrastPalette()
                                                : fusion->standardPalette());
}

QMenu* NewThemeMenu(QWidget* parent)
{
  auto* const menu = new QMenu(QCoreApplication::translate("Theme", "&Theme"), parent);
  const std::pair<Theme, QString> themes[] = {
    { Theme::System, QCoreApplication::translate("Theme", "As on the &desktop") },
    { Theme::Light, QCoreApplication::translate("Theme", "&Light") },
    { Theme::Dark, QCoreApplication::translate("Theme", "D&ark") },
    { Theme::HighContrast, QCoreApplication::translate("Theme", "High &contrast") },
  };
  auto* const group = new QActionGroup(menu);
  for (const auto& [theme, text] : themes)
  {
    QAction* const action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    action->setChecked(theme == ChosenTheme());
    QObject::connect(action, &QAction::triggered, menu,
      [theme = theme]
      {
        QSettings().setValue(Key, ThemeNames().at(theme));
        ApplyTheme(theme);
      });
  }
  return menu;
}

}
