#ifndef Varimarch_Testing_OverlapScene_h
#define Varimarch_Testing_OverlapScene_h

#include "Core/Geometry/PixelRays.h"
#include "Core/Geometry/ScalarGrid.h"
#include "Core/Quality/ImageError.h"
#include "Core/Reference/ReferenceIntegrator.h"
#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/ComponentVolumes.h"

#include <vtkMultiVolume.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// One of several volumes, in the world.
struct WorldMaterial
{
  varimarch::VolumeGeometry geometry;
  std::vector<double> voxels;
  ComponentLook look;
  bool nearest;
  bool shaded;

  /// The place where voxels are read [grid space], if it is in the volume.
  std::optional<glm::dvec3> PlaceOf(glm::dvec3 positionWorld) const;
  double ValueAt(glm::dvec3 placeGrid) const;
  glm::dvec3 NormalAt(glm::dvec3 placeGrid) const; ///< unit vector, along the gradient
  double ExtinctionOf(double value) const;         ///< [1/mm]

  /// Its optical properties in a head light.
  varimarch::OpticalProperties At(glm::dvec3 positionWorld, glm::dvec3 toEye) const;

  varimarch::ScalarGrid<double> Grid() const
  {
    return { this->voxels.data(), this->geometry.dimensions };
  }
};

using MaterialInWorld =
  std::function<varimarch::OpticalProperties(glm::dvec3 positionWorld, glm::dvec3 toEye)>;

/// Overlapping volumes, set up as by a program that uses vtkMultiVolume, with their true image.
/// Seen along -z in parallel projection, 24 mm of the world around its origin.
class OverlapScene
{
public:
  explicit OverlapScene(int size = 32);

  /// Adds the volume of a port. Its property has the given look and linear interpolation.
  vtkVolume* Add(int port, vtkImageData* image, const ComponentLook& look);
  void Remove(int port);

  /// Draws by the mapper itself, which has features that a vtkGPUVolumeRayCastMapper lacks.
  void UseMapperItself();

  /// The image in float: premultiplied RGBA without the background, rendered by a shader or, where
  /// possible, by the processor.
  std::vector<float> Draw();
  std::vector<float> DrawByProcessor();

  /// The reference's image of the sum of all volumes, with a head light for shaded volumes.
  std::vector<float> Truth();
  varimarch::ImageError Error(); ///< the larger error of both

  std::vector<vtkVolume*> Volumes() const;
  std::vector<WorldMaterial> Materials() const;
  /// The reference's image of a sum of materials.
  std::vector<float> TruthOf(const std::vector<MaterialInWorld>& materials, double tolerance);

  varimarch::PixelRays RaysWorld();
  std::vector<std::string> ShaderParts();

  int size;
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkMultiVolume> several = vtkSmartPointer<vtkMultiVolume>::New();
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> mapper;

private:
  struct Part
  {
    vtkSmartPointer<vtkImageData> image;
    vtkSmartPointer<vtkVolume> volume;
    ComponentLook look;
  };
  std::map<int, Part> parts; ///< by port
};

inline vtkVariationFieldVolumeMapper* MapperOf(OverlapScene& scene)
{
  return scene.mapper->GetVariationFieldMapper();
}

/// True if the last shader has a file of a folder, or this file.
bool UsesPart(OverlapScene& scene, const std::string& folder);

/// An image of doubles over a box centred at the world's origin [mm].
vtkSmartPointer<vtkImageData> CenteredImage(
  glm::ivec3 dimensions, glm::dvec3 sizeMm, const std::function<double(glm::dvec3 voxel)>& value);

/// A box with one value everywhere.
vtkSmartPointer<vtkImageData> HomogeneousBox(glm::dvec3 sizeMm);

/// Appearance of two balls with soft rims, at an angle and with different voxel sizes.
struct BallLooks
{
  bool firstShaded;
  bool secondShaded;
  bool firstNearest;
  bool secondNearest;
};

inline const ComponentLook ballLooks[] = { { { 1.0, 0.3, 0.1 }, 20.0, 100.0, 0.15 },
  { { 0.2, 0.5, 1.0 }, 10.0, 120.0, 0.3 } };

/// The value of a ball at a place, both in voxels.
double BallField(glm::dvec3 place, glm::dvec3 center);

void AddBalls(OverlapScene& scene, const BallLooks& looks, const int (&ports)[2] = { 0, 1 });

#endif
