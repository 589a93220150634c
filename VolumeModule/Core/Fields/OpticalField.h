#ifndef Varimarch_Core_Fields_OpticalField_h
#define Varimarch_Core_Fields_OpticalField_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/Box.h"
#include "Core/Look/TransferFunction.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// How far a ray may go before what is *seen* changes: the variation field with the transfer
/// function taken into account. One byte per brick of BrickRanges:
///   0            structured: march it
///   1            homogeneous: one sample stands for the whole brick
///   128 + k      invisible, and so are all bricks [b - k, b + k] on each axis, cut at the
///                volume's faces: a ray may leave the block without a sample. Where all rays go the
///                same way along an axis, they are [b, b + k] or [b - k, b]: behind a surface,
///                which a ray has left, the blocks are then large at once
/// It is a matter of milliseconds: a change of the transfer function makes a new one, and leaves
/// the ranges, which read the whole volume, as they are.
struct OpticalField
{
  static constexpr std::uint8_t Structured = 0;
  static constexpr std::uint8_t Homogeneous = 1;
  static constexpr std::uint8_t Invisible = 128;
  static constexpr int LargestRadius = 127;

  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<std::uint8_t> bricks; ///< x fastest

  /// The part of the bricks in a box of whole bricks [grid space] that a ray takes in one step.
  double SkippablePart(const Box& boxGrid) const;
};

/// What a brick must keep to count as homogeneous. With s the extinction [1/mm] and c a colour
/// channel over the values of the brick:
///   max s - min s <= max(relativeExtinction * min s, opticalDepth / longestRayMm)
///   max c - min c <= color
/// An image drawn with one sample per homogeneous brick is then off by at most
/// color + 2 (relativeExtinction + opticalDepth) in a premultiplied channel, to first order,
/// whatever the length of the ray and the number of bricks (Documentation/Mathematics.md).
struct OpticalTolerance
{
  double relativeExtinction;
  double opticalDepth;
  double color;
  double longestRayMm;

  /// Splits a largest error of a premultiplied channel over the three.
  static OpticalTolerance ForError(double error, double longestRayMm)
  {
    return { error / 8.0, error / 8.0, error / 2.0, longestRayMm };
  }

  /// No brick is homogeneous: for pictures in which more than the values of a brick is seen, such
  /// as the light on its gradients.
  static OpticalTolerance Nothing(double longestRayMm) { return { 0.0, 0.0, -1.0, longestRayMm }; }
};

/// The values of one component of a volume, and what the shader will look up for them.
struct OpticalChannel
{
  const BrickRanges& ranges;
  const OpticalTable& table;
};

/// Builds the field on all cores. A brick of several components is invisible where all of them are,
/// and homogeneous where each is or is invisible; to a largest error, each may add as much.
/// @param channels  at least one, of one volume
/// @param towards   see DirectionsOf: the field is for rays of these directions only
OpticalField BuildOpticalField(const std::vector<OpticalChannel>& channels,
  const OpticalTolerance& tolerance, glm::ivec3 towards = glm::ivec3(0));

inline OpticalField BuildOpticalField(const BrickRanges& ranges, const OpticalTable& table,
  const OpticalTolerance& tolerance, glm::ivec3 towards = glm::ivec3(0))
{
  return BuildOpticalField({ OpticalChannel{ ranges, table } }, tolerance, towards);
}

/// The field for isosurfaces: bricks that none of them passes are invisible, the others structured.
OpticalField BuildIsosurfaceField(const BrickRanges& ranges, const std::vector<double>& isovalues,
  glm::ivec3 towards = glm::ivec3(0));

}

#endif
