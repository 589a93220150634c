#ifndef Varimarch_Scene_SceneOverlays_h
#define Varimarch_Scene_SceneOverlays_h

#include "Scene/Model/Scene.h"
#include "Scene/Segments/LabelMap.h"

#include <vtkImageData.h>
#include <vtkMultiVolume.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <memory>
#include <vector>

namespace varimarch
{

/// True if a mapper can draw several volumes in one march. VTK's fixed-point mapper draws one.
bool CanOverlay(MapperKind kind);

/// True if the volumes that are shown together, with their segmentations, are at most MostVolumes.
bool AreAllSegmentsDrawn(const Scene& scene);

/// The voxels of a volume over the first one.
struct OverlayVoxels
{
  vtkSmartPointer<vtkImageData> image;         ///< null for one that could not be read
  std::shared_ptr<const LabelMap> labels = {}; ///< null without a segmentation
};

/// The segments of the first volume, as they look now.
struct FirstSegments
{
  const LabelMap* labels; ///< null without a segmentation
  vtkImageData* numbers;  ///< the labels without what scissors remove, see LabelMask
  const std::vector<Segment>& segments;
  const Shading& shading;
};

/// The volumes over the first one of a ScenePipeline, which draws all of them as the parts of a
/// vtkMultiVolume with one mapper. Hidden ones are no parts. The segments of each are a part of
/// their own, which adds its light to what the look shows there, while there are at most
/// MostVolumes parts.
class SceneOverlays
{
public:
  /// @param first  the volume at the mapper's first port; must outlive this object
  SceneOverlays(MapperKind kind, vtkVolumeMapper* mapper, vtkVolume* first);

  /// Replaces all of them. Where only looks and places differ, the mapper keeps its voxels.
  /// @param voxels  of the overlays, in their order
  void Set(const std::vector<OverlaidVolume>& overlays, const std::vector<OverlayVoxels>& voxels,
    const FirstSegments& firstSegments);

  void SetInterpolationType(int type);

  /// True if any is drawn. The mapper then draws composites only, without masks and a number of
  /// steps.
  bool Any() const { return !this->parts.empty(); }

  /// The prop that is drawn: the first volume, or all of them.
  vtkVolume* Prop() const;

private:
  struct Part
  {
    vtkSmartPointer<vtkImageData> source;
    vtkSmartPointer<vtkImageData> image; ///< the voxels that are drawn
    vtkSmartPointer<vtkVolumeProperty> property;
    Placement placement;
    bool isLabels; ///< its voxels are boxes
    vtkSmartPointer<vtkVolume> volume = {};
  };

  vtkSmartPointer<vtkImageData> DrawnVoxels(vtkImageData* source) const;
  void SetParts(std::vector<Part> wanted);
  void ConnectParts(std::size_t countBefore);
  void ShowPart(const Part& part) const;

  MapperKind kind;
  vtkVolumeMapper* mapper;
  vtkVolume* first;
  vtkSmartPointer<vtkMultiVolume> several;
  int interpolationType = VTK_LINEAR_INTERPOLATION;
  std::vector<Part> parts; ///< at the ports from 1 on
};

}

#endif
