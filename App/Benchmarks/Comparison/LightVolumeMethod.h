#ifndef Varimarch_Benchmarks_Comparison_LightVolumeMethod_h
#define Varimarch_Benchmarks_Comparison_LightVolumeMethod_h

#include "ComparedView.h"

#include <vtkNew.h>
#include <vtkTextureObject.h>

#include <glm/vec3.hpp>

#include <cstddef>

namespace varimarch
{

/// Shadows from a volume of light that is made before the picture: T. Gorkin, "Volume rendering
/// using graphics hardware" (2009), slides 12 and 32, "Precomputed Light Transmissivity". A second
/// march leads from each point of a grid to a distant light; samples get what the grid says, by
/// trilinear interpolation. It depends on the volume, its look and the light, not on the view.
class LightVolumeMethod
{
public:
  /// Draws slices parallel to the image into the bound image, whose blending is "over" for slices
  /// from the back to the front, and "under" for the opposite order.
  /// @param mostPoints  points of the grid along the longest axis of the volume, >= 2; an axis has
  ///                    no more points than voxels
  void Draw(const ComparisonFrame& frame, int mostPoints, bool fromBehind);

  std::size_t Bytes() const; ///< texture of the light
  void Release(vtkWindow* window);

private:
  void Update(const ComparisonFrame& frame, int mostPoints);

  vtkNew<vtkTextureObject> light;
  glm::dvec3 builtFor = glm::dvec3(0.0); ///< direction towards the light
  int builtVersion = -1;                 ///< version of the volume; -1: there is no texture
  int builtMostPoints = 0;
};

}

#endif
