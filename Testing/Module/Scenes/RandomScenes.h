#ifndef Varimarch_Testing_RandomScenes_h
#define Varimarch_Testing_RandomScenes_h

#include "Core/Look/ValueRange.h"
#include "Module/Scenes/Dice.h"
#include "Module/Scenes/MapperScene.h"

#include <memory>
#include <string>

/// A random volume of any type, shape and content.
struct RandomVolume
{
  vtkSmartPointer<vtkImageData> image;
  varimarch::ValueRange values; ///< the values of nearly all voxels, without a far fill value
  bool hasGaps;                 ///< true if some voxels are not finite or blanked
  bool hasFarValues;            ///< true if some voxels may be far beyond the values
  std::string description;
};

/// @param components  1 to 4
RandomVolume MakeRandomVolume(Dice& dice, int components);

/// Gives a component random transfer functions for its values, and lights.
/// @param smooth  true for functions without jumps and peaks
/// @return a description
std::string SetRandomLook(
  vtkVolumeProperty* property, int component, const RandomVolume& volume, bool smooth, Dice& dice);

/// Places the volume and the camera.
/// @return a description
std::string SetRandomView(MapperScene& scene, Dice& dice);

/// Sets clipping planes and cropping, or none.
/// @return a description
std::string SetRandomCuts(MapperScene& scene, Dice& dice);

/// The edges at which a pixel depends on tiny shifts of its ray.
enum class RandomEdges
{
  None,
  Faces, ///< boxes, isosurfaces, steps of functions
  Hard,  ///< opaque values, and far values, which make steps of ramps
};

/// A scene that a seed determines, and its true image.
class RandomScene
{
public:
  RandomScene(std::uint64_t seed, vtkHeadlessRenderWindow* window);

  /// The seed and everything that it has chosen, in one line.
  const std::string& Description() const { return this->description; }

  std::vector<float> Draw();
  std::vector<float> Truth(); ///< for the present camera

  RandomEdges Edges() const { return this->edges; }

  /// False if a whole voxel or cell may have a value so close to a step of a function that its look
  /// is between those of either side, because a step is a ramp as wide as an entry of the table.
  bool IsExact() const;

  MapperScene& Scene() { return *this->scene; }

private:
  void SetBlend(Dice& dice);
  void SetMaterial(Dice& dice);
  void SetQuality(Dice& dice);
  void SetGradientOpacity(Dice& dice);

  int components;
  bool isMixture; ///< true if the material depends on more than one value and its light
  RandomEdges edges = RandomEdges::None;
  RandomVolume volume;
  std::unique_ptr<MapperScene> scene;
  std::string description;
};

#endif
