#ifndef Varimarch_Viewer_PresetTitles_h
#define Varimarch_Viewer_PresetTitles_h

#include "Scene/PresetSuggestion.h"

#include <QString>

#include <string>

namespace varimarch
{

/// Title of a built-in preset in the user's language, such as "Bone". For other looks, their name.
QString PresetTitle(const std::string& name);

/// Reason for a suggested preset, as the end of a sentence in the user's language.
QString SuggestionText(const PresetSuggestion& suggestion);

}

#endif
