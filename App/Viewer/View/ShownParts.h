#ifndef Varimarch_Viewer_ShownParts_h
#define Varimarch_Viewer_ShownParts_h

#include "Scene/ScenePipeline.h"
#include "Viewer/Model/SceneModel.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

namespace varimarch
{

/// The voxels that a pipeline draws.
struct ShownVoxels
{
  vtkSmartPointer<vtkImageData> volume;
  std::shared_ptr<const LabelMap> labels; ///< null without a segmentation
  std::vector<OverlayVoxels> overlays;
};

/// The voxels of a study, not copied.
ShownVoxels VoxelsOf(const Study& study);

/// Takes a part of a scene into the pipeline that draws it. For a new volume the pipeline must be a
/// new one of this scene.
/// @return false for a part that no picture of the volume shows
bool ShowPart(
  ScenePart part, const Scene& scene, const ShownVoxels& voxels, ScenePipeline& pipeline);

}

#endif
