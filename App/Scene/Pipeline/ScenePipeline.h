#ifndef Varimarch_Scene_ScenePipeline_h
#define Varimarch_Scene_ScenePipeline_h

#include "Scene/Model/Scene.h"
#include "Scene/Pipeline/SceneOverlays.h"
#include "Scene/Segments/LabelMap.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <memory>
#include <vector>

namespace varimarch
{

/// True if a mapper supports a blend mode. VTK's fixed-point mapper lacks average and isosurface.
bool CanBlend(MapperKind kind, Blend blend);

/// True if a mapper supports scissors. VTK's fixed-point mapper has no masks.
bool CanCutByScissors(MapperKind kind);

/// True if a mapper can draw labels over a volume: in composites of one component. VTK's
/// fixed-point mapper has no masks.
bool CanDrawLabels(MapperKind kind, Blend blend, vtkImageData* image);

/// True if a mapper draws the regions of a look, if it has any: in composites of one component.
/// VTK's fixed-point mapper knows no transfer functions of two values. Labels are not drawn with
/// regions.
bool CanDrawRegions(MapperKind kind, Blend blend, vtkImageData* image);

/// Turns a scene into a VTK pipeline of volume, property, mapper, renderer and camera; the only
/// place that does. Owns no window: add Renderer() to a window of the scene's size.
class ScenePipeline
{
public:
  /// @param image  the volume that the scene's source names; shared, not copied
  ScenePipeline(const Scene& scene, vtkImageData* image, MapperKind kind);

  vtkRenderer* Renderer() const { return this->renderer; }
  vtkVolume* Volume() { return this->volume; }
  vtkVolumeMapper* Mapper() { return this->mapper; }

  vtkImageData* Image() const { return this->image; }

  /// The look that is drawn, in units of the data and in millimetres.
  const Look& DrawnLook() const { return this->look; }

  /// The part that scissors and BodyMask keep, see SceneCuts.h; null if they keep all.
  vtkImageData* Mask() const { return this->mask; }

  /// Draws other voxels of the same grid, such as those of another time. What removes the table or
  /// the face stays as it was made for the first voxels.
  void SetImage(vtkImageData* newImage);

  /// Each setter changes one part of the scene and keeps the volume.
  void SetLook(const Look& look);
  void SetCamera(const Camera& camera, double aspect);
  void SetCuts(const SceneCuts& cuts);
  /// Draws labels over the volume where CanDrawLabels; null draws none. Their segments look as they
  /// say.
  void SetLabels(std::shared_ptr<const LabelMap> newLabels);
  /// Changes the look of the segments, and keeps their voxels.
  /// @param changed  as many as the labels have, in their order
  void SetSegments(const std::vector<Segment>& changed);
  /// Draws volumes over the first one where CanOverlay. All of them are then composites, without
  /// a number of steps; see SceneOverlays. While the face is removed, none is drawn, since they
  /// have faces too.
  /// @param voxels  of the overlays, in their order
  void SetOverlays(
    const std::vector<OverlaidVolume>& overlays, const std::vector<OverlayVoxels>& voxels);
  void SetRenderOptions(const RenderOptions& options);
  void SetLights(const std::vector<SceneLight>& lights);
  /// VTK's mappers cast no shadows, scatter no light, and have no ambient occlusion.
  void SetLighting(const Lighting& lighting);
  void SetBackground(const std::array<double, 3>& rgb);

  /// Sample distance of the last frame [mm].
  double UsedSampleDistanceMm() const;

private:
  bool DrawsLabels() const;
  bool DrawsRegions() const;
  void MakeMask(const SceneCuts& cuts);
  void ApplyProperty();
  void ApplyBlend();
  void ApplyLight();
  void ApplyMask();
  void ApplyFirstImage();
  void ApplyVoxels();
  void ApplyOverlays();
  void ApplyInterpolation();
  void SetMask(vtkImageData* voxels, bool areLabels);

  MapperKind kind;
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkImageData> voxels; ///< the image, or its colours, as the mapper draws it
  Look look;                            ///< in units of the data
  RenderOptions options;
  Lighting lighting;
  std::vector<ScissorsCut> scissors; ///< the cuts that made the mask
  bool bodyOnly = false;
  double faceDepthMm = 0.0;
  vtkSmartPointer<vtkImageData> body; ///< see BodyMask.h; null before it is wanted
  vtkSmartPointer<vtkImageData> mask;
  std::shared_ptr<const LabelMap> labels;  ///< null without labels
  std::vector<Segment> segments;           ///< the look of the labels' segments
  vtkSmartPointer<vtkImageData> labelMask; ///< labels without what scissors remove
  vtkSmartPointer<vtkVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;
  SceneOverlays overlays;
  std::vector<OverlaidVolume> wantedOverlays;
  std::vector<OverlayVoxels> wantedVoxels;
  vtkSmartPointer<vtkImageData> mapperMask; ///< the mask that the mapper's voxels have; may be null
  vtkNew<vtkRenderer> renderer;
};

}

#endif
