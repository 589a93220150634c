#ifndef Varimarch_Scene_SceneOverlays_h
#define Varimarch_Scene_SceneOverlays_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkMultiVolume.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <vector>

namespace varimarch
{

/// True if a mapper can draw several volumes in one march. VTK's fixed-point mapper draws one.
bool CanOverlay(MapperKind kind);

/// The volumes over the first one of a ScenePipeline, which draws all of them as the parts of a
/// vtkMultiVolume with one mapper. Hidden ones are no parts.
class SceneOverlays
{
public:
  /// @param first  the volume at the mapper's first port; must outlive this object
  SceneOverlays(MapperKind kind, vtkVolumeMapper* mapper, vtkVolume* first);

  /// Replaces all of them. Where only looks and places differ, the mapper keeps its voxels.
  /// @param images  of the overlays, in their order; null for one that could not be read
  void Set(const std::vector<OverlaidVolume>& overlays,
    const std::vector<vtkSmartPointer<vtkImageData>>& images);

  void SetInterpolationType(int type);

  /// True if any is drawn. The mapper then draws composites only, without masks, shadows,
  /// scattered light, ambient occlusion and a number of steps.
  bool Any() const { return !this->parts.empty(); }

  /// The prop that is drawn: the first volume, or all of them.
  vtkVolume* Prop() const;

private:
  struct Part
  {
    vtkSmartPointer<vtkImageData> image;
    vtkSmartPointer<vtkVolume> volume;
  };

  void SetImages(const std::vector<vtkSmartPointer<vtkImageData>>& shown);

  MapperKind kind;
  vtkVolumeMapper* mapper;
  vtkVolume* first;
  vtkSmartPointer<vtkMultiVolume> several;
  int interpolationType = VTK_LINEAR_INTERPOLATION;
  std::vector<Part> parts; ///< at the ports from 1 on
};

}

#endif
