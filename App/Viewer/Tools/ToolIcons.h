#ifndef Varimarch_Viewer_ToolIcons_h
#define Varimarch_Viewer_ToolIcons_h

#include "Viewer/Tools/MouseTools.h"

#include <QIcon>

namespace varimarch
{

/// The icon of a tool of the tool bar. It is drawn anew at each size, in the colour of the texts of
/// buttons, so that it follows the theme. Annotations share the pencil of their menu.
QIcon IconOf(LeftButton button);

/// The icon of the menu of annotations, a pencil.
QIcon AnnotationIcon();

}

#endif
