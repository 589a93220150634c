#ifndef Varimarch_Core_ReferenceIntegrator_h
#define Varimarch_Core_ReferenceIntegrator_h

#include "Core/Box.h"
#include "Core/CellCubic.h"
#include "Core/RenderSettings.h"
#include "Core/SlabQuadrature.h"
#include "Core/TransferBands.h"

#include <glm/vec4.hpp>

#include <functional>

namespace varimarch
{

/// What the reference draws. A cell with a voxel that is not finite is left out: it is transparent,
/// and no maximum.
struct ReferenceScene
{
  /// The voxels, as [&grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); } gives them.
  std::function<CellCorners(glm::ivec3)> cornersOfCell;
  Box boxGrid; ///< what is drawn; beyond the voxels their outermost values go on
  TransferFunction transferFunction;
  Blend blend = Blend::Composite;

  /// Makes the transfer function's colour at a place, seen along a direction of any length, what
  /// is emitted there; none: the colour itself. Composite only.
  std::function<glm::dvec3(glm::dvec3 rgb, glm::dvec3 positionGrid, glm::dvec3 directionGrid)>
    shade = {};
};

struct ReferenceColor
{
  glm::dvec4 rgba; ///< premultiplied
  double error;    ///< estimate of the largest error of a channel
};

/// The truth that images are measured against: the volume rendering integral of one ray in double
/// precision, to a stated tolerance. It shares no formula with the shaders.
///
/// The ray is cut at every cell face, and inside a cell, where the interpolated values are a cubic,
/// wherever that cubic crosses a node of the transfer function. The pieces are smooth, and are
/// integrated adaptively (SlabQuadrature); what is invisible, constant or opaque is exact. See
/// Documentation/Mathematics.md.
class ReferenceIntegrator
{
public:
  static constexpr double SmallestTolerance = 1e-12;

  /// @param tolerance  largest accepted error of a premultiplied channel, >= SmallestTolerance
  /// @throws std::invalid_argument for a smaller tolerance, or a scene without voxels
  explicit ReferenceIntegrator(ReferenceScene scene, double tolerance = 1e-9);

  /// @param rayGrid         in grid space
  /// @param mmPerParameter  length of the ray's direction in the world [mm], > 0
  /// @param limits          the part of the ray that counts, of which the scene's box cuts more off
  ReferenceColor Color(const Ray& rayGrid, double mmPerParameter,
    Interval limits = { 0.0, std::numeric_limits<double>::infinity() }) const;

private:
  ReferenceColor MaximumColor(const Ray& rayGrid, Interval inside) const;
  ReferenceColor CompositeColor(const Ray& rayGrid, double mmPerParameter, Interval inside) const;

  ReferenceScene scene;
  double tolerance;
  TransferBands bands;
  SlabQuadrature quadrature;
};

}

#endif
