#ifndef Varimarch_March_LevelOfDetail_h
#define Varimarch_March_LevelOfDetail_h

#include "Core/Fields/VolumeSummary.h"
#include "Frame/Frame.h"
#include "March/RayMarcher.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>

class vtkDataArray;
class vtkImageData;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// True if an image is drawn while somebody interacts, for less time than a still one may take.
bool IsInteractive(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame);

/// Draws volumes that stayed in their file by their coarse level, which is in memory, and bounds
/// the error of that. It owns the image of the level, which shares the summary's voxels, and a
/// marcher, so that neither level discards what belongs to the other.
class LevelOfDetail
{
public:
  /// The frame of the coarse level, to be drawn by Marcher(), if the mapper wants it instead of a
  /// frame of voxels and the volume has one.
  /// @throws std::runtime_error as BuildFrame does
  std::optional<Frame> FrameInstead(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const Frame& frame);

  RayMarcher& Marcher() { return this->marcher; }

  /// The largest error that the level of the last frame can have anywhere in the image, see
  /// LevelBounds; 0 for the voxels themselves, 1 if it is not known.
  double ErrorBound() const { return this->bound ? this->bound() : 0.0; }

  void Release(vtkWindow* window);

private:
  void UpdateImage(const std::shared_ptr<const VolumeSummary>& newSummary,
    vtkDataArray* scalarsOfVoxels, vtkImageData* voxels);

  std::shared_ptr<const VolumeSummary> summary;
  vtkSmartPointer<vtkImageData> image;
  RayMarcher marcher;
  std::function<double()> bound; ///< null for the voxels themselves
};

}

#endif
