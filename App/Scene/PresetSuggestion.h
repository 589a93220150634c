#ifndef Varimarch_Scene_PresetSuggestion_h
#define Varimarch_Scene_PresetSuggestion_h

#include "Scene/ImageStatistics.h"
#include "Scene/VolumeLoading.h"

#include <string>

namespace varimarch
{

/// What a preset was chosen by.
enum class SuggestionReason
{
  Modality,      ///< that the file names
  BodyPart,      ///< that the file names
  ContrastAgent, ///< of which the file tells
  Weighting,     ///< of MR, that the file's times tell
  Metal,         ///< in the histogram: more than a little is denser than any bone
  ValuesOfAir,   ///< in the histogram, in Hounsfield units: it must be CT
  OtherValues    ///< the histogram goes down to no air, and nothing else is known
};

struct PresetSuggestion
{
  std::string name;
  SuggestionReason reason;
  std::string said; ///< by the file: the modality, body part or weighting; else empty
};

/// The preset that shows most of what a volume was probably made for.
PresetSuggestion SuggestedPreset(const LoadedVolume& volume, const ImageStatistics& statistics);

}

#endif
