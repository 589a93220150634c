#ifndef Varimarch_Viewer_Theme_h
#define Varimarch_Viewer_Theme_h

class QMenu;
class QWidget;

namespace varimarch
{

enum class Theme
{
  System, ///< as the desktop has it
  Light,
  Dark,
};

/// That the user has chosen; remembered in the settings.
Theme ChosenTheme();

/// Gives all windows the colours of a theme.
void ApplyTheme(Theme theme);

/// A menu of the themes, whose choice is applied and remembered.
/// @param parent  owns it
QMenu* NewThemeMenu(QWidget* parent);

}

#endif
