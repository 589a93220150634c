#ifndef Varimarch_Scene_Presets_h
#define Varimarch_Scene_Presets_h

#include "Scene/Json/SceneNames.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Names of the built-in presets. The files of Data/Presets are compiled in, so that none has to be
/// found at run time.
std::vector<std::string> PresetNames();

bool IsPresetName(const std::string& name);

/// @throws std::invalid_argument for a name that is not in PresetNames()
Preset BuiltInPreset(const std::string& name);

/// True if a look still equals the preset that it is named after, for a volume with these
/// statistics.
bool IsBuiltInLook(const Look& look, const ImageStatistics& statistics);

/// Applies a preset to a scene.
void TakePreset(const Preset& preset, Scene& scene);

/// The preset that gives other scenes the look of this one.
Preset PresetOf(const Scene& scene);

struct PresetFile
{
  const char* name;
  const char* json;
};

/// Contents of the files in Data/Presets. The build generates this table.
const std::vector<PresetFile>& PresetFiles();

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

/// A grey scale that radiologists use for a part of the body [HU].
struct WindowPreset
{
  std::string name; ///< English
  double window;
  double level;
};

/// The usual windows of CT, at most nine. Empty for other modalities, whose values have no common
/// unit.
/// @param modality  of DICOM, such as "CT"
const std::vector<WindowPreset>& WindowPresetsOf(const std::string& modality);

/// Named shadings, from the softest to the hardest.
const NameTable<Shading>& ShadingPresets();

/// Name of a shading; empty if it equals none of the named ones.
std::optional<std::string> NameOfShading(const Shading& shading);

/// A sequential colour map, from dark to light, readable with any kind of colour vision.
struct ColorMap
{
  std::string name;
  std::vector<ColorNode> nodes; ///< values from 0 to 1
};

/// Viridis, inferno and plasma by S. van der Walt and N. Smith (2015), cividis by J. Nunez, C.
/// Anderton and R. Renslow (PLOS ONE 13(7), 2018), each within 4/255 of the original, and grey.
const std::vector<ColorMap>& ColorMaps();

/// Spreads a colour map over a look, from its first opacity node to its last, and colours its
/// isosurfaces from the same map.
/// @param smallest, largest  value range of the volume, used when all opacity nodes have one value
Look WithColorMap(const Look& look, const ColorMap& map, double smallest, double largest);

}

#endif
