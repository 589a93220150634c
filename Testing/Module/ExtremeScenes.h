#ifndef Varimarch_Testing_ExtremeScenes_h
#define Varimarch_Testing_ExtremeScenes_h

#include "Module/MapperScene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A scene at the limits of numbers, geometries or transfer functions.
struct ExtremeScene
{
  std::string name;
  std::function<vtkSmartPointer<vtkImageData>()> image;
  std::function<void(MapperScene&)> prepare; ///< sets transfer function, camera and settings
};

std::vector<ExtremeScene> ExtremeMaterials(); ///< opacities and transfer functions
std::vector<ExtremeScene> HardSurfaces();     ///< opaque from one value to the next
std::vector<ExtremeScene> ExtremeScalars();   ///< ranges, offsets, values that are not finite
std::vector<ExtremeScene> ThinShapes();       ///< one voxel thick
std::vector<ExtremeScene> ExtremeShapes();    ///< stretched, tiny and huge volumes
std::vector<ExtremeScene> ExtremeViews();     ///< cameras and clipping ranges
/// Sample distances, without an error tolerance.
std::vector<ExtremeScene> ExtremesWithoutTolerance();

/// Sets a scene up in a window, with the mapper's default error tolerance.
std::unique_ptr<MapperScene> MapperSceneOf(
  const ExtremeScene& scene, int size, vtkHeadlessRenderWindow* window);

#endif
