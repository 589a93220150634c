#include "Viewer/PanelTabs.h"

#include <QDockWidget>
#include <QSignalBlocker>

namespace varimarch
{

PanelTabs::PanelTabs(const std::vector<QDockWidget*>& newPanels, QWidget* parent)
  : QTabBar(parent)
  , panels(newPanels)
{
  this->setObjectName("panelTabs");
  this->setDrawBase(false);
  this->setElideMode(Qt::ElideNone);
  this->setUsesScrollButtons(true);
  for (int i = 0; i < int(this->panels.size()); ++i)
  {
    QDockWidget* const panel = this->panels[std::size_t(i)];
    this->addTab(panel->windowTitle());
    connect(panel, &QDockWidget::visibilityChanged, this,
      [this, i](bool isVisible)
      {
        if (isVisible)
        {
          const QSignalBlocker quiet(this);
          this->setCurrentIndex(i);
        }
      });
  }
  // A click on the current tab brings a panel back that was closed.
  connect(this, &QTabBar::tabBarClicked, this, &PanelTabs::Raise);
  connect(this, &QTabBar::currentChanged, this, &PanelTabs::Raise);
}

void PanelTabs::Raise(int panel)
{
  if (panel >= 0)
  {
    this->panels[std::size_t(panel)]->show();
    this->panels[std::size_t(panel)]->raise();
  }
}

// Qt shows them again whenever it arranges the panels, so they have no extent instead.
void HideTabsOfQt(QTabBar* tabs)
{
  tabs->setDrawBase(false);
  tabs->setFocusPolicy(Qt::NoFocus);
  tabs->setStyleSheet("QTabBar::tab { width: 0; height: 0; margin: 0; padding: 0; border: none }");
}

QWidget* RaisePanel(const QWidget* window, const char* name)
{
  auto* const panel = window->findChild<QDockWidget*>(name);
  panel->show();
  panel->raise();
  return panel;
}

}
