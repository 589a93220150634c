#ifndef Varimarch_Testing_HomogeneousScene_h
#define Varimarch_Testing_HomogeneousScene_h

#include "Module/Scenes/MapperScene.h"

#include <vtkActor.h>

#include <array>

/// A cube of one material, 16 mm on a side, centred at the world's origin, seen along -z in
/// parallel projection. It fills the image, and its colour through any length has a closed form.
class HomogeneousScene : public MapperScene
{
public:
  static constexpr double SideMm = 16.0;

  explicit HomogeneousScene(double opacityPerMm = 0.1, int size = 32);

  /// Premultiplied RGBA of a piece of the material.
  std::array<double, 4> Piece(double lengthMm) const;

  std::array<double, 3> rgb = { 0.9, 0.6, 0.3 };
  double opacityPerMm;
};

/// A cube whose voxels have a single value.
vtkSmartPointer<vtkImageData> HomogeneousCube(double sideMm);

/// Sets one colour and one opacity per mm for all values.
void UseOneMaterial(vtkVolumeProperty* property, const std::array<double, 3>& rgb, double opacity);

/// An unlit rectangle across the view, from xMm to the right, tall enough to fill the image.
vtkSmartPointer<vtkActor> Plane(double zMm, double fromXMm, const std::array<double, 3>& rgb);

/// Composites premultiplied RGBA, front over back.
std::array<double, 4> Over(const std::array<double, 4>& front, const std::array<double, 4>& back);

#endif
