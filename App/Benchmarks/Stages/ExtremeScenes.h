#ifndef Varimarch_Benchmarks_ExtremeScenes_h
#define Varimarch_Benchmarks_ExtremeScenes_h

#include "Stages/VolumeStage.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

/// A scene at the limits of numbers, geometries or transfer functions.
struct ExtremeScene
{
  std::string name;
  std::function<vtkSmartPointer<vtkImageData>()> image;
  std::function<void(VolumeStage&)> prepare; ///< sets transfer function, camera and settings
};

std::vector<ExtremeScene> ExtremeMaterials(); ///< opacities and transfer functions
std::vector<ExtremeScene> HardSurfaces();     ///< opaque from one value to the next
std::vector<ExtremeScene> ExtremeScalars();   ///< ranges, offsets, values that are not finite
std::vector<ExtremeScene> ThinShapes();       ///< one voxel thick
std::vector<ExtremeScene> ExtremeShapes();    ///< stretched, tiny and huge volumes
std::vector<ExtremeScene> ExtremeViews();     ///< cameras and clipping ranges
/// Sample distances, without an error tolerance.
std::vector<ExtremeScene> ExtremesWithoutTolerance();

/// Sets a scene up in a window, with the mapper's defaults.
std::unique_ptr<VolumeStage> StageOf(
  const ExtremeScene& scene, int size, vtkHeadlessRenderWindow* window);

}

#endif
