#ifndef Varimarch_Testing_HomogeneousScene_h
#define Varimarch_Testing_HomogeneousScene_h

#include "Module/MapperScene.h"

#include <vtkActor.h>

#include <array>

/// A cube of one material, 16 mm on a side around the origin of the world, that fills the picture,
/// seen along -z in parallel projection: what is seen of it through a length has a closed form.
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

/// All voxels have one value.
vtkSmartPointer<vtkImageData> HomogeneousCube(double sideMm);

/// A colour of 1 opacity per mm for all values.
void UseOneMaterial(vtkVolumeProperty* property, const std::array<double, 3>& rgb, double opacity);

/// A rectangle without light across the view, from xMm to the right, far up and down.
vtkSmartPointer<vtkActor> Plane(double zMm, double fromXMm, const std::array<double, 3>& rgb);

/// What is in front of what: premultiplied RGBA.
std::array<double, 4> Over(const std::array<double, 4>& front, const std::array<double, 4>& back);

#endif
