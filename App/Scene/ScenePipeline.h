#ifndef Varimarch_Scene_ScenePipeline_h
#define Varimarch_Scene_ScenePipeline_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <vector>

namespace varimarch
{

/// Whether a mapper can blend so: VTK's fixed-point mapper draws no average and no isosurface.
bool CanBlend(MapperKind kind, Blend blend);

/// Whether a mapper draws what scissors leave: VTK's fixed-point mapper has no masks.
bool CanCutByScissors(MapperKind kind);

/// The one place where a scene becomes a VTK pipeline: volume, property, mapper, renderer and
/// camera. It makes no window: add Renderer() to one of the scene's size.
class ScenePipeline
{
public:
  /// @param image  the volume that the scene's source names; shared, not copied
  ScenePipeline(const Scene& scene, vtkImageData* image, MapperKind kind);

  vtkRenderer* Renderer() const { return this->renderer; }
  vtkVolume* Volume() { return this->volume; }
  vtkVolumeMapper* Mapper() { return this->mapper; }

  /// What the scissors leave, see Scissors.h; null where none cut.
  vtkImageData* Mask() const { return this->mask; }

  /// Each changes one part of the scene; the volume stays.
  void SetLook(const Look& look);
  void SetCamera(const Camera& camera, double aspect);
  void SetCuts(const SceneCuts& cuts);
  void SetRenderOptions(const RenderOptions& options);
  void SetBackground(const std::array<double, 3>& rgb);

  /// The distance between the samples of the last picture [mm].
  double UsedSampleDistanceMm() const;

private:
  void SetScissors(const std::vector<ScissorsCut>& cuts);

  vtkSmartPointer<vtkImageData> image;
  std::vector<ScissorsCut> scissors; ///< that the mask is of
  vtkSmartPointer<vtkImageData> mask;
  vtkSmartPointer<vtkVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
};

}

#endif
