#ifndef Varimarch_Viewer_KeyImageTexts_h
#define Varimarch_Viewer_KeyImageTexts_h

#include "Scene/Scene.h"

#include <QString>

namespace varimarch
{

/// The name of a key image, or the view that it shows: "Axial slice".
QString TitleOf(const KeyImage& image);

/// "Axial slice".
QString TitleOf(KeyView view);

}

#endif
