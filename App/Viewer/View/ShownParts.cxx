#include "Viewer/View/ShownParts.h"

#include "Scene/SceneLights.h"

namespace varimarch
{

ShownVoxels VoxelsOf(const Study& study)
{
  return { study.volume.image, study.labels, VoxelsOfOverlays(study) };
}

bool ShowPart(
  ScenePart part, const Scene& scene, const ShownVoxels& voxels, ScenePipeline& pipeline)
{
  switch (part)
  {
    case ScenePart::Volume:
      return ShowPart(ScenePart::Labels, scene, voxels, pipeline);
    case ScenePart::Voxels:
      pipeline.SetImage(voxels.volume);
      return true;
    case ScenePart::Look:
      pipeline.SetLook(scene.look);
      [[fallthrough]];
    case ScenePart::Overlays:
      pipeline.SetOverlays(scene.overlays, voxels.overlays);
      return true;
    case ScenePart::Lights:
      pipeline.SetLighting(LightingOf(scene));
      return true;
    case ScenePart::Cuts:
      pipeline.SetCuts(scene.cuts);
      return true;
    case ScenePart::Labels:
      pipeline.SetLabels(voxels.labels);
      [[fallthrough]];
    case ScenePart::Segments:
      if (scene.labels)
      {
        pipeline.SetSegments(scene.labels->segments);
      }
      pipeline.SetOverlays(scene.overlays, voxels.overlays);
      return true;
    case ScenePart::Render:
      pipeline.SetRenderOptions(scene.render);
      return true;
    case ScenePart::Background:
      pipeline.SetBackground(scene.background);
      return true;
    default:
      return false;
  }
}

}
