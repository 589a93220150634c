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

struct ValueRange
{
  double lower;
  double upper;
};

/// The light along the part of a ray in one cell, over u in [0, 1].
struct PieceLight
{
  /// What is emitted at u, where the transfer function's colour is rgb.
  std::function<glm::dvec3(glm::dvec3 rgb, double u)> emitted;
  std::vector<double> kinks = {}; ///< where it is not smooth, sorted, in (0, 1)
};

/// What the reference draws. A cell with a voxel that is not finite is left out: it is transparent
/// but for `gap`, no maximum or minimum, no part of an average, and no surface bounds it.
struct ReferenceScene
{
  /// The voxels, as [&grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); } gives them.
  std::function<CellCorners(glm::ivec3)> cornersOfCell;
  Box boxGrid; ///< what is drawn; beyond the voxels their outermost values go on
  TransferFunction transferFunction;
  Blend blend = Blend::Composite;

  /// The light along a part of a ray, such as HeadLightShading; none: colours are emitted as they
  /// are. Composite and isosurface only.
  std::function<PieceLight(const CellPart& part, const Ray& rayGrid)> shade = {};

  /// Average and additive: the values that are black and white, those of the darkest and the
  /// brightest voxel for VTK's picture.
  ValueRange grayRange = { 0.0, 1.0 };

  /// Average: only these values count, both ends included.
  ValueRange averagedRange = { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };

  /// Isosurface: a surface bounds what is at least this value; any order.
  std::vector<double> isovalues = {};

  /// Composite: what a point looks like along a ray, in place of voxels, transfer function and
  /// light; smooth within halves of cells. None: they tell.
  std::function<OpticalProperties(glm::dvec3 positionGrid, const Ray& rayGrid)> material = {};

  /// Composite: the homogeneous material, not lit, of cells that touch a voxel that is not finite.
  OpticalProperties gap = { glm::dvec3(0.0), 0.0 };

  /// What cuts leave of the part of a ray inside the box, front to back; none: all of it.
  std::function<std::vector<Interval>(const Ray& rayGrid, Interval inside)> leftOf = {};
};

}

#endif
