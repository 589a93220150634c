#ifndef Varimarch_Benchmarks_ExtremeScenes_h
#define Varimarch_Benchmarks_ExtremeScenes_h

#include "Stages/VolumeStage.h"

#include <array>
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

/// Building blocks of extreme scenes: small volumes of smooth lumps, transfer functions, cameras.
namespace extreme
{

using Dimensions = std::array<int, 3>;
using Spacing = std::array<double, 3>;
using Image = std::function<vtkSmartPointer<vtkImageData>()>;
using Preparation = std::function<void(VolumeStage&)>;

constexpr Dimensions SmallBox = { 11, 9, 10 };

/// Values from `first` to `first + range`, asymmetric, centred at the origin.
Image Lumpy(Dimensions dimensions = SmallBox, int type = VTK_FLOAT, double first = 0.0,
  double range = 1.0, Spacing spacing = { 1.0, 1.0, 1.0 });

/// The same with a given value in some of the voxels.
Image LumpyWith(
  double value, const std::vector<Dimensions>& voxels, Dimensions dimensions = SmallBox);

Image Constant(double value, int type = VTK_FLOAT);

/// Transparent over the lowest two fifths of the values, then a ramp of opacity.
Preparation LookAt(double first, double range, double opacity = 0.3);

void UsualLook(VolumeStage& scene);
void DenseLook(VolumeStage& scene);

struct Node
{
  double value;
  double opacity;
};

/// Given opacities, with colours from first to last.
Preparation Opacities(const std::vector<Node>& nodes, double first = 0.0, double last = 1.0);

/// The usual look for opacities that hold over this distance.
Preparation UnitDistance(double distanceMm);

struct Viewpoint
{
  std::array<double, 3> position;
  std::array<double, 3> focalPoint;
  double angle = 30.0;
  std::array<double, 2> clippingRange = { 0.01, 100.0 };
};

Preparation SeenFrom(const Viewpoint& view);

/// Pixels half a voxel apart, so that rays pass through voxels, along edges and in cell faces.
Preparation SeenAlong(std::array<double, 3> direction, double sideVoxels = 0.5);

}

}

#endif
