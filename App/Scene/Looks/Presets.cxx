#include "Scene/Looks/Presets.h"

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/VolumeProperty.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>
#include <vector>

namespace varimarch
{

std::vector<std::string> PresetNames()
{
  std::vector<std::string> names;
  for (const PresetFile& preset : PresetFiles())
  {
    names.push_back(preset.name);
  }
  return names;
}

bool IsPresetName(const std::string& name)
{
  const std::vector<std::string> names = PresetNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Preset BuiltInPreset(const std::string& name)
{
  for (const PresetFile& preset : PresetFiles())
  {
    if (name == preset.name)
    {
      return PresetFromText(preset.json, "preset " + name);
    }
  }
  throw std::invalid_argument(
    "unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
}

bool IsBuiltInLook(const Look& look, const ImageStatistics& statistics)
{
  return IsPresetName(look.name) &&
    LookText(InUnitsOfData(BuiltInPreset(look.name).look, statistics)) == LookText(look);
}

void TakePreset(const Preset& preset, Scene& scene)
{
  scene.look = preset.look;
  scene.render.errorTolerance = preset.errorTolerance.value_or(scene.render.errorTolerance);
  scene.background = preset.background.value_or(scene.background);
}

Preset PresetOf(const Scene& scene)
{
  return { scene.look, scene.render.errorTolerance, scene.background };
}

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

const std::vector<WindowPreset>& WindowPresetsOf(const std::string& modality)
{
  static const std::vector<WindowPreset> ofCt = {
    { "Abdomen", 400.0, 50.0 },
    { "Lungs", 1500.0, -600.0 },
    { "Mediastinum", 350.0, 50.0 },
    { "Bone", 1800.0, 400.0 },
    { "Brain", 80.0, 40.0 },
    { "Subdural", 200.0, 75.0 },
    { "Stroke", 40.0, 40.0 },
    { "Liver", 150.0, 30.0 },
    { "Vessels", 600.0, 170.0 },
  };
  static const std::vector<WindowPreset> none;
  return modality == "CT" ? ofCt : none;
}

namespace
{

// With shading off, the coefficients do not matter.
bool AreAlike(const Shading& a, const Shading& b)
{
  return a.enabled == b.enabled &&
    (!a.enabled ||
      (a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
        a.specularPower == b.specularPower));
}

}

const NameTable<Shading>& ShadingPresets()
{
  static const NameTable<Shading> presets = {
    { "soft", { true, 0.35, 0.65, 0.05, 8.0 } },
    { "clinical", { true, 0.15, 0.85, 0.2, 10.0 } },
    { "glossy", { true, 0.1, 0.75, 0.6, 48.0 } },
    { "flat", { false, 1.0, 0.0, 0.0, 1.0 } },
  };
  return presets;
}

std::optional<std::string> NameOfShading(const Shading& shading)
{
  for (const auto& [name, preset] : ShadingPresets())
  {
    if (AreAlike(shading, preset))
    {
      return name;
    }
  }
  return std::nullopt;
}

namespace
{

// Position, red, green and blue, each from 0 to 255.
using Node = std::array<int, 4>;

ColorMap MapOf(const char* name, const std::vector<Node>& nodes)
{
  ColorMap map{ name, {} };
  for (const Node& node : nodes)
  {
    map.nodes.push_back({ node[0] / 255.0, { node[1] / 255.0, node[2] / 255.0, node[3] / 255.0 } });
  }
  return map;
}

std::pair<double, double> ValuesOf(const Look& look, double smallest, double largest)
{
  const double first = look.opacities.front().value;
  const double last = look.opacities.back().value;
  return first < last ? std::pair(first, last) : std::pair(smallest, largest);
}

}

const std::vector<ColorMap>& ColorMaps()
{
  static const std::vector<ColorMap> maps = {
    MapOf("viridis",
      { { 0, 68, 1, 84 }, { 30, 71, 42, 122 }, { 58, 62, 76, 138 }, { 125, 33, 142, 141 },
        { 153, 34, 168, 132 }, { 174, 59, 187, 117 }, { 193, 96, 202, 96 }, { 240, 216, 226, 25 },
        { 246, 231, 228, 25 }, { 255, 253, 231, 37 } }),
    MapOf("cividis",
      { { 0, 0, 34, 78 }, { 22, 0, 49, 113 }, { 35, 32, 58, 111 }, { 53, 56, 71, 108 },
        { 152, 147, 142, 120 }, { 203, 199, 183, 103 }, { 234, 233, 211, 78 },
        { 251, 253, 227, 52 }, { 255, 254, 232, 56 } }),
    MapOf("inferno",
      { { 0, 0, 0, 4 }, { 19, 14, 9, 43 }, { 40, 47, 10, 91 }, { 51, 66, 10, 104 },
        { 64, 87, 16, 110 }, { 105, 152, 39, 102 }, { 146, 212, 72, 66 }, { 172, 239, 108, 35 },
        { 194, 250, 146, 7 }, { 201, 252, 159, 7 }, { 209, 252, 174, 18 }, { 225, 248, 205, 55 },
        { 244, 241, 241, 121 }, { 255, 252, 255, 164 } }),
    MapOf("plasma",
      { { 0, 13, 8, 135 }, { 9, 36, 6, 145 }, { 31, 75, 3, 161 }, { 65, 128, 4, 168 },
        { 91, 163, 30, 154 }, { 138, 213, 83, 111 }, { 173, 239, 124, 81 }, { 202, 252, 163, 56 },
        { 224, 253, 197, 39 }, { 251, 242, 242, 39 }, { 255, 240, 249, 33 } }),
    MapOf("grey", { { 0, 0, 0, 0 }, { 255, 255, 255, 255 } }),
  };
  return maps;
}

Look WithColorMap(const Look& look, const ColorMap& map, double smallest, double largest)
{
  const auto [first, last] = ValuesOf(look, smallest, largest);
  Look colored = look;
  colored.colors = map.nodes;
  for (ColorNode& node : colored.colors)
  {
    node.value = first + node.value * (last - first);
  }
  const TransferFunction function(colored.colors, {}, 1.0);
  for (Isosurface& surface : colored.isosurfaces)
  {
    surface.rgb = function.Color(surface.value);
  }
  return colored;
}

}
