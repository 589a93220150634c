#ifndef Varimarch_Core_Reference_ReferenceScene_h
#define Varimarch_Core_Reference_ReferenceScene_h

#include "Core/Box.h"
#include "Core/CellCubic.h"
#include "Core/RenderSettings.h"
#include "Core/TransferFunction.h"

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

/// What the reference draws. A cell with a voxel that is not finite is left out: it is transparent,
/// no maximum or minimum, no part of an average, and no surface bounds it.
struct ReferenceScene
{
  /// The voxels, as [&grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); } gives them.
  std::function<CellCorners(glm::ivec3)> cornersOfCell;
  Box boxGrid; ///< what is drawn; beyond the voxels their outermost values go on
  TransferFunction transferFunction;
  Blend blend = Blend::Composite;

  /// Makes the transfer function's colour at a place, seen along a direction of any length, what
  /// is emitted there; none: the colour itself. Composite and isosurface only.
  std::function<glm::dvec3(glm::dvec3 rgb, glm::dvec3 positionGrid, glm::dvec3 directionGrid)>
    shade = {};

  /// Average and additive: the values that are black and white, those of the darkest and the
  /// brightest voxel for VTK's picture.
  ValueRange grayRange = { 0.0, 1.0 };

  /// Average: only these values count, both ends included.
  ValueRange averagedRange = { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };

  /// Isosurface: a surface bounds what is at least this value; any order.
  std::vector<double> isovalues = {};
};

}

#endif
