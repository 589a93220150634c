#ifndef Varimarch_Viewer_KeyImageTexts_h
#define Varimarch_Viewer_KeyImageTexts_h

#include "Scene/Scene.h"

#include <QString>

namespace varimarch
{

struct LoadedTimes;

/// The name of a key image, or the view that it shows: "Axial slice".
QString TitleOf(const KeyImage& image);

/// "Axial slice".
QString TitleOf(KeyView view);

/// True if the volume has the time that a key image names.
bool IsAtTime(const KeyImage& image, const LoadedTimes& times);

/// The time of a key image, as TimeText writes it; empty unless the volume has it.
QString TimeTextOf(const KeyImage& image, const LoadedTimes& times);

}

#endif
