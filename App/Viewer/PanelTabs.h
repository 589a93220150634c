#ifndef Varimarch_Viewer_PanelTabs_h
#define Varimarch_Viewer_PanelTabs_h

#include <QTabBar>

#include <vector>

class QDockWidget;

namespace varimarch
{

/// The titles of all panels, one of which is shown at a time. They stand at the right of the tool
/// bar, where there is room for them in every language; Qt's own tabs above the stacked panels hid
/// most of them behind arrows.
class PanelTabs : public QTabBar
{
public:
  /// @param newPanels  outlive this
  explicit PanelTabs(const std::vector<QDockWidget*>& newPanels, QWidget* parent = nullptr);

private:
  void Raise(int panel);

  std::vector<QDockWidget*> panels;
};

/// Shows a panel of a window, in front of those that share its place.
/// @param name  its object name
QWidget* RaisePanel(const QWidget* window, const char* name);

/// Hides the tabs that Qt makes above stacked panels.
void HideTabsOfQt(QTabBar* tabs);

}

#endif
