#include "Scene/PresetSuggestion.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace varimarch
{

namespace
{

// Limits in Hounsfield units.
constexpr double HighestAir = -900.0;
constexpr double LowestMetal = 2800.0;

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
    return { LookOfPart(volume.bodyPart), SuggestionReason::BodyPart, volume.bodyPart };
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
  if (statistics.Smallest() <= HighestAir)
  {
    return ForCt(volume, statistics, { "ct-bone", SuggestionReason::ValuesOfAir, "" });
  }
  return { "mr-head", SuggestionReason::OtherValues, "" };
}

}
