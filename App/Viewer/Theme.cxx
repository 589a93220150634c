#include "Viewer/Theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QPalette>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>

#include <tuple>

namespace varimarch
{

namespace
{

const char* const Key = "window/theme";

QPalette DarkPalette()
{
  const QColor window(45, 47, 51);
  const QColor base(30, 31, 34);
  const QColor text(228, 228, 228);
  const QColor faint(140, 140, 140);
  const QColor highlight(52, 120, 190);
  QPalette palette(QColor(62, 64, 69), window); // buttons are lighter than the window
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Highlight, highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(110, 180, 250));
  for (const QPalette::ColorRole role :
    { QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText })
  {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::BrightText, Qt::white);
  return palette;
}

}

Theme ChosenTheme()
{
  const QString name = QSettings().value(Key).toString();
  return name == "dark" ? Theme::Dark : name == "light" ? Theme::Light : Theme::System;
}

void ApplyTheme(Theme theme)
{
  // Remember the desktop's style to return to it.
  static const QString systemStyle = QApplication::style()->objectName();
  if (theme == Theme::System)
  {
    QApplication::setStyle(systemStyle);
    QApplication::setPalette(QPalette());
    return;
  }
  QStyle* const fusion = QStyleFactory::create("Fusion");
  QApplication::setStyle(fusion);
  QApplication::setPalette(theme == Theme::Dark ? DarkPalette() : fusion->standardPalette());
}

QMenu* NewThemeMenu(QWidget* parent)
{
  auto* const menu = new QMenu(QCoreApplication::translate("Theme", "&Theme"), parent);
  const std::tuple<Theme, QString, QString> themes[] = {
    { Theme::System, QCoreApplication::translate("Theme", "As on the &desktop"), "system" },
    { Theme::Light, QCoreApplication::translate("Theme", "&Light"), "light" },
    { Theme::Dark, QCoreApplication::translate("Theme", "D&ark"), "dark" },
  };
  auto* const group = new QActionGroup(menu);
  for (const auto& [theme, text, name] : themes)
  {
    QAction* const action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    action->setChecked(theme == ChosenTheme());
    QObject::connect(action, &QAction::triggered, menu,
      [theme = theme, name = name]
      {
        QSettings().setValue(Key, name);
        ApplyTheme(theme);
      });
  }
  return menu;
}

}
