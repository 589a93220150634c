#include "Scene/PresetSuggestion.h"

#include "Scene/HounsfieldScale.h"
#include "Scene/Presets.h"
#include "Scene/VolumeProperty.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace varimarch
{

namespace
{

// Limits in Hounsfield units.
constexpr double LowestMetal = 2800.0;

constexpr double LowestLung = -900.0;
constexpr double HighestLung = -500.0;
constexpr double LowestTissue = -250.0;

// Share of the lungs in the body, without the air around it. Scans of the chest have several times
// as much, and scans below the chest have hardly any.
constexpr double LeastLungOfChest = 0.05;

// Windows for lungs are centred near -600, those for soft tissue between 30 and 60.
constexpr double HighestLevelForLungs = -300.0;

// Dental fillings cover less than this, and need no look of their own.
constexpr double LeastPercentOfMetal = 0.2;

// Body parts that are usually viewed for soft tissue or air rather than bone. The words are
// prefixes of their names in DICOM (PS3.16, annex L) and of the names that scanners write.
struct PartLook
{
  const char* preset;
  std::vector<std::string> parts;
};

const std::vector<PartLook>& PartLooks()
{
  static const std::vector<PartLook> looks = {
    { "ct-lung", { "CHEST", "THORAX", "LUNG", "BRONCHUS" } },
    { "ct-vessels", { "HEART", "AORTA", "CORONARY", "CAROTID", "CIRCLEOFWILLIS" } },
    { "ct-soft-tissue",
      { "ABDOMEN", "LIVER", "KIDNEY", "PANCREAS", "SPLEEN", "COLON", "BLADDER", "UTERUS" } },
  };
  return looks;
}

std::string LookOfPart(std::string part)
{
  std::transform(part.begin(), part.end(), part.begin(),
    [](unsigned char letter) { return std::toupper(letter); });
  for (const PartLook& look : PartLooks())
  {
    for (const std::string& begin : look.parts)
    {
      if (part.compare(0, begin.size(), begin) == 0)
      {
        return look.preset;
      }
    }
  }
  return "ct-bone";
}

double LungShare(const ImageStatistics& statistics)
{
  double lung = 0.0;
  double tissue = 0.0;
  for (std::size_t bin = 0; bin < statistics.Counts().size(); ++bin)
  {
    const double value = statistics.Smallest() + double(bin) * statistics.BinSpacing();
    const double count = double(statistics.Counts()[bin]);
    lung += value >= LowestLung && value <= HighestLung ? count : 0.0;
    tissue += value >= LowestTissue ? count : 0.0;
  }
  return lung > 0.0 ? lung / (lung + tissue) : 0.0;
}

// Files of the abdomen often name the chest.
PresetSuggestion ForBodyPart(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  const std::string look = LookOfPart(volume.bodyPart);
  if (look == "ct-lung" && volume.windowLevel && (*volume.windowLevel)[1] > HighestLevelForLungs)
  {
    return { "ct-bone", SuggestionReason::TissueWindow, volume.bodyPart };
  }
  if (look == "ct-lung" && LungShare(statistics) < LeastLungOfChest)
  {
    return { "ct-bone", SuggestionReason::LittleLung, volume.bodyPart };
  }
  return { look, SuggestionReason::BodyPart, volume.bodyPart };
}

PresetSuggestion ForCt(
  const LoadedVolume& volume, const ImageStatistics& statistics, const PresetSuggestion& otherwise)
{
  if (statistics.Percentile(100.0 - LeastPercentOfMetal) > LowestMetal)
  {
    return { "ct-implants", SuggestionReason::Metal, "" };
  }
  if (volume.hasContrastAgent)
  {
    return { "ct-vessels", SuggestionReason::ContrastAgent, "" };
  }
  if (!volume.bodyPart.empty())
  {
    return ForBodyPart(volume, statistics);
  }
  return otherwise;
}

PresetSuggestion ForMr(const LoadedVolume& volume)
{
  if (volume.weighting.empty())
  {
    return { "mr-head", SuggestionReason::Modality, volume.modality };
  }
  const std::string name = volume.weighting == "T2" ? "mr-t2"
    : volume.weighting == "angiography"             ? "mr-angiography"
                                                    : "mr-head";
  return { name, SuggestionReason::Weighting, volume.weighting };
}

}

PresetSuggestion SuggestedPreset(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  if (volume.modality == "CT" && !Suits(BuiltInPreset("ct-bone").look, statistics))
  {
    return { "mr-maximum", SuggestionReason::OtherValues, "" };
  }
  if (volume.modality == "CT")
  {
    return ForCt(volume, statistics, { "ct-bone", SuggestionReason::Modality, volume.modality });
  }
  if (volume.modality == "MR")
  {
    return ForMr(volume);
  }
  if (volume.modality == "PT")
  {
    return { "pet-maximum", SuggestionReason::Modality, volume.modality };
  }
  if (!volume.modality.empty())
  {
    return { "mr-maximum", SuggestionReason::Modality, volume.modality };
  }
  if (statistics.Smallest() <= HighestAirHu)
  {
    return ForCt(volume, statistics, { "ct-bone", SuggestionReason::ValuesOfAir, "" });
  }
  return { "mr-head", SuggestionReason::OtherValues, "" };
}

}
