#ifndef Varimarch_Viewer_PresetTitles_h
#define Varimarch_Viewer_PresetTitles_h

#include "Scene/PresetSuggestion.h"

#include <QString>

#include <string>

namespace varimarch
{

/// What a preset that comes with the program is called on the screen: "Bone", in the user's
/// language; of another look its name.
QString PresetTitle(const std::string& name);

/// Why a preset was suggested, for the end of a sentence, in the user's language.
QString SuggestionText(const PresetSuggestion& suggestion);

}

#endif
