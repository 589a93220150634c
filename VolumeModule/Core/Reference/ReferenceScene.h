#ifndef Varimarch_Core_Reference_ReferenceScene_h
#define Varimarch_Core_Reference_ReferenceScene_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/CellCubic.h"
#include "Core/Geometry/CellWalk.h"
#include "Core/Look/TransferBands.h"
#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/RenderSettings.h"

#include <functional>
#include <limits>
#include <vector>

namespace varimarch
{

/// Light along the part of a ray in one cell, over u in [0, 1].
struct PieceLight
{
  /// Emitted colour at u for a colour rgb of the transfer function.
  std::function<glm::dvec3(glm::dvec3 rgb, double u)> emitted;
  std::vector<double> kinks = {}; ///< sorted parameters in (0, 1) at which the light is not smooth
};

/// A scene for the reference integrator. A cell with a non-finite voxel is left out: it is
/// transparent unless `gap` is visible, it does not count in projections, and it has no
/// isosurfaces.
struct ReferenceScene
{
  /// The values at a cell's corners, such as [&grid](glm::ivec3 cell) { return CornersOfCell(grid,
  /// cell); }
  std::function<CellCorners(glm::ivec3)> cornersOfCell;
  Box boxGrid; ///< the volume; outside the outermost voxels their values continue
  TransferFunction transferFunction;
  Blend blend = Blend::Composite;

  /// The light along a part of a ray, such as HeadLightShading; without it, colours are emitted
  /// unchanged. For composites and isosurfaces.
  std::function<PieceLight(const CellPart& part, const Ray& rayGrid)> shade = {};

  /// For average and additive intensity: the values shown as black and white. VTK uses the smallest
  /// and the largest voxel value.
  ValueRange grayRange = { 0.0, 1.0 };

  /// For average intensity: the values that count, both ends included.
  ValueRange averagedRange = { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };

  /// For isosurfaces: isovalues in any order. A surface encloses what is at least its isovalue.
  std::vector<double> isovalues = {};

  /// For composites: the optical properties at a position on a ray, smooth within halves of cells.
  /// If set, they replace voxels, transfer function and light.
  std::function<OpticalProperties(glm::dvec3 positionGrid, const Ray& rayGrid)> material = {};

  /// For composites: the homogeneous, unshaded material of cells that touch a non-finite voxel.
  OpticalProperties gap = { glm::dvec3(0.0), 0.0 };

  /// The parts of a ray inside the box that cuts leave, front to back; without it, all of the ray.
  std::function<std::vector<Interval>(const Ray& rayGrid, Interval inside)> uncutParts = {};
};

}

#endif
