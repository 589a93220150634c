#ifndef Varimarch_Testing_AnalyticScenes_h
#define Varimarch_Testing_AnalyticScenes_h

#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"
#include "Core/Reference/ReferenceImage.h"

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// A small volume whose rays have a closed form. The value at voxel (i, j, k) is a sum
/// x[i] + y[j] + z[k], so that trilinear interpolation is linear along a ray inside a cell,
/// exactly; and the transfer function has straight pieces of extinction and colour, so that a ray
/// is a row of pieces in which both are linear. Documentation/Mathematics.md has the integral of
/// one.
///
/// The closed form is of the very scene that is drawn, interpolation included: there is no limit of
/// fine voxels or nodes in it.
struct AnalyticScene
{
  std::string name;
  std::array<std::vector<double>, 3> values; ///< along x, y and z
  glm::dvec3 spacingMm;                      ///< the first voxel is at the world's origin
  TransferFunction transferFunction;

  glm::ivec3 Dimensions() const;
  std::vector<double> Voxels() const; ///< x fastest
  Box BoxGrid() const { return { glm::dvec3(0.0), glm::dvec3(this->Dimensions() - 1) }; }

  /// The premultiplied colour of a ray within the box.
  glm::dvec4 Color(const MeasuredRay& ray) const;

  /// Colours of all pixels, row 0 the lowest.
  std::vector<float> Picture(const ReferenceView& view) const;
};

/// Constant slab, linear ramp, exponential, two media with an oblique interface, veil before an
/// opaque wall, ball, Gaussian ball, thin shell.
std::vector<AnalyticScene> AnalyticScenes();

/// Emission and absorption over a length in which extinction and colour go linearly from front to
/// back: colour seen from the front, and opacity.
glm::dvec4 LinearPieceColor(
  const OpticalProperties& front, const OpticalProperties& back, double lengthMm);

}

#endif
