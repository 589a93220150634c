#ifndef Varimarch_Viewer_Theme_h
#define Varimarch_Viewer_Theme_h

class QMenu;
class QWidget;

namespace varimarch
{

enum class Theme
{
  System, ///< the desktop's theme
  Light,
  Dark,
  HighContrast, ///< white and yellow on black
};

/// The user's choice, kept in the settings.
Theme ChosenTheme();

/// Applies a theme's colours to all windows.
void ApplyTheme(Theme theme);

/// A menu of the themes that applies and saves the choice.
/// @param parent  owner of the menu
QMenu* NewThemeMenu(QWidget* parent);

}

#endif
