#ifndef Varimarch_Testing_AnalyticScenes_h
#define Varimarch_Testing_AnalyticScenes_h

#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"
#include "Core/Reference/ReferenceIntegrator.h"

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// A small volume whose rays have a closed form. The value at voxel (i, j, k) is the sum x[i] +
/// y[j] + z[k], so that trilinear interpolation is exactly linear along a ray inside a cell. The
/// transfer function has linear pieces of extinction and colour, so that a ray is a sequence of
/// pieces in which both are linear. Documentation/Mathematics.md derives the integral over a piece.
///
/// The closed form describes the rendered scene itself, including interpolation; it is not a limit
/// for fine voxels or nodes.
struct AnalyticScene
{
  std::string name;
  std::array<std::vector<double>, 3> values; ///< terms along x, y and z
  glm::dvec3 spacingMm;                      ///< the first voxel is at the world's origin
  TransferFunction transferFunction;

  glm::ivec3 Dimensions() const;
  std::vector<double> Voxels() const; ///< voxel values, x fastest
  Box BoxGrid() const { return { glm::dvec3(0.0), glm::dvec3(this->Dimensions() - 1) }; }

  /// Premultiplied colour of a ray within the box.
  glm::dvec4 Color(const MeasuredRay& ray) const;

  /// Colours of all pixels, the bottom row first.
  std::vector<float> Picture(const ReferenceView& view) const;
};

/// All scenes: constant slab, linear ramp, exponential, two media with an oblique interface, veil
/// before an opaque wall, ball, Gaussian ball, thin shell.
std::vector<AnalyticScene> AnalyticScenes();

/// Emission and absorption over a length along which extinction and colour change linearly from
/// front to back: premultiplied colour seen from the front, and opacity.
glm::dvec4 LinearPieceColor(
  const OpticalProperties& front, const OpticalProperties& back, double lengthMm);

}

#endif
