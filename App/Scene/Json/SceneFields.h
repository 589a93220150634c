#ifndef Varimarch_Scene_SceneFields_h
#define Varimarch_Scene_SceneFields_h

#include "Scene/Json/Fields.h"
#include "Scene/Model/Scene.h"

namespace varimarch
{

// The fields of the structs of a scene file. A new setting is a line in one of these lists.

const Fields<Scene>& SceneFields();
/// The same without the key "volume", for a caller that has the volume already.
const Fields<Scene>& FieldsBesideVolume();
const Fields<Preset>& PresetFields();
const Fields<Look>& LookFields();
const Fields<Camera>& CameraFields();
const Fields<SceneCuts>& CutsFields();
const Fields<SliceSettings>& SlicesFields();
const Fields<RenderOptions>& RenderFields();

/// The keys of light, for a struct that has its members.
template <class Lit>
void AddLightFields(Fields<Lit>& fields);

JsonForm<VolumeSource> VolumeForm();
/// A preset as an object, or the name of a built-in one.
JsonForm<Preset> PresetForm();
JsonForm<std::vector<LookRegion>> RegionsForm();
JsonForm<SceneLabels> LabelsForm();
JsonForm<std::vector<Segment>> SegmentsForm();
JsonForm<std::vector<OverlaidVolume>> OverlaysForm();
/// The measurements of a scene under the key "measures", and older lists of them.
void AddMeasureFields(Fields<Scene>& fields);

template <std::size_t count>
bool IsAscending(const std::array<double, count>& values)
{
  return values[0] < values[1];
}

inline bool HasLength(const std::array<double, 3>& direction)
{
  return direction != std::array<double, 3>{};
}

}

#endif
