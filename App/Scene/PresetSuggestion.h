#ifndef Varimarch_Scene_PresetSuggestion_h
#define Varimarch_Scene_PresetSuggestion_h

#include "Scene/ImageStatistics.h"
#include "Scene/VolumeLoading.h"

#include <string>

namespace varimarch
{

/// The fact that decided on a preset.
enum class SuggestionReason
{
  Modality,      ///< named in the file
  BodyPart,      ///< named in the file
  TissueWindow,  ///< the file names the chest, but its window shows soft tissue
  LittleLung,    ///< the file names the chest, but few values are those of lungs
  ContrastAgent, ///< named in the file
  Weighting,     ///< T1 or T2, from the echo and repetition times in the file
  Metal,         ///< in the histogram: more than a few voxels are denser than any bone
  ValuesOfAir,   ///< in the histogram, at Hounsfield units of air: the volume must be CT
  OtherValues    ///< nothing is known, and no value lies as low as air in CT
};

struct PresetSuggestion
{
  std::string name;
  SuggestionReason reason;
  std::string said; ///< modality, body part or weighting as the file names it; otherwise empty
};

/// Chooses the preset that best fits the purpose of the scan.
PresetSuggestion SuggestedPreset(const LoadedVolume& volume, const ImageStatistics& statistics);

}

#endif
