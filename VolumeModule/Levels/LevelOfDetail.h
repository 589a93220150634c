#ifndef Varimarch_Levels_LevelOfDetail_h
#define Varimarch_Levels_LevelOfDetail_h

#include "Core/Fields/VolumeSummary.h"
#include "Frame/Frame.h"
#include "Levels/LevelRefinement.h"
#include "March/RayMarcher.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// True if an image is drawn while somebody interacts, for less time than a still one may take.
bool IsInteractive(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame);

/// The image that a renderer shows to one eye.
struct DrawnView
{
  vtkWeakPointer<vtkRenderer> renderer;
  bool isLeftEye = true;
  std::size_t lastDrawing = 0;                 ///< the number of the last drawing of the view
  bool isComplete = true;                      ///< false if a further image would be more exact
  std::unique_ptr<LevelRefinement> refinement; ///< null before the first of RefinedLevel
  Fingerprint begun;        ///< fingerprint of the scene that began with the coarse level
  bool beginsStill = false; ///< true until the coarse level of that scene is drawn whole
};

/// The level of an image.
struct DrawnLevel
{
  int level = 0;                 ///< VoxelLevel, CoarseLevel or RefinedLevel of the mapper.
  std::size_t visibleBlocks = 0; ///< 0 for images of a single level.
  std::size_t refinedBlocks = 0; ///< Visible blocks that are drawn by voxels.
  bool nextFits = true;          ///< See LevelRefinement::NextFits.
};

/// Draws volumes that stayed in their file by their coarser levels, in the blocks where they
/// suffice, or by the coarsest alone, which is in memory, and bounds the error of that. It owns the
/// images of the levels, which share the voxels of the summary and of the file, and a marcher for
/// the coarsest alone, so that neither it nor the voxels discard what belongs to the other.
class LevelOfDetail
{
public:
  /// The frame to be drawn instead of a frame of voxels, if the mapper wants it and the volume has
  /// a coarse level: one of the level, to be drawn by Marcher(), or of voxels with blocks of the
  /// level.
  /// @param lastIsWhole  false if the last image was drawn in part
  /// @throws std::runtime_error as BuildFrame does
  std::optional<Frame> FrameInstead(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole);

  /// The frame of the coarse level, to be drawn by Marcher(), if the next image of a frame of
  /// voxels takes that level alone; none for other images. It changes nothing about the next image.
  /// @throws std::runtime_error as BuildFrame does
  std::optional<Frame> CoarseFrameAhead(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole);

  RayMarcher& Marcher() { return this->marcher; }

  /// The largest error that the level of the last frame can have anywhere in the image, see
  /// LevelBounds; 0 for the voxels themselves, 1 if it is not known.
  double ErrorBound() const { return this->bound ? this->bound() : 0.0; }

  /// The level of the last frame.
  const DrawnLevel& Drawn() const { return this->drawn; }

  /// True if further images of the views that are drawn in turn would be more exact.
  bool MayBeRefined() const;

  /// True if a further image of the view that was drawn last would be more exact.
  bool LastMayBeRefined() const { return !this->views.empty() && !this->views.front().isComplete; }

  void Release(vtkWindow* window);

private:
  void UpdateImages(const std::shared_ptr<const VolumeSummary>& newSummary,
    vtkDataArray* scalarsOfVoxels, vtkImageData* voxels);
  std::optional<Frame> CoarseFrame(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame);
  int LevelNow(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame, bool lastIsWhole);
  std::list<DrawnView>::iterator FindView(const Frame& frame);
  /// The view of a frame, which becomes the first of all.
  DrawnView& ViewOf(const Frame& frame);
  /// The next image of the view is the first one of its scene.
  void ForgetScene(DrawnView& view);
  /// Goes on with the scene of a fingerprint, or begins it.
  void Refine(
    DrawnView& view, const Fingerprint& fingerprint, const LevelInputs& inputs, double tolerance);
  Frame RefinedFrame(
    const LevelRefinement& refinement, const Frame& frame, std::vector<Frame> coarser);
  /// The frames of all levels, from the finest on.
  std::vector<Frame> LevelFrames(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame);

  std::shared_ptr<const VolumeSummary> summary;
  std::vector<MiddleLevel> middle;                   ///< See BlockLooks.
  std::vector<vtkSmartPointer<vtkImageData>> images; ///< The levels, the coarsest last.
  RayMarcher marcher;
  std::function<double()> bound; ///< null for the voxels themselves
  std::list<DrawnView> views;    ///< The view that was drawn last is the first.
  std::size_t drawings = 0;      ///< The number of drawings of all views.
  DrawnLevel drawn;
};

}

#endif
