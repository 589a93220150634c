#ifndef Varimarch_Core_Fields_OpticalField_h
#define Varimarch_Core_Fields_OpticalField_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Fields/BrickRows.h"
#include "Core/Geometry/Box.h"
#include "Core/Look/OpticalTable.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// A field that says how far a ray may go before what is *seen* changes: a variation field that
/// takes the transfer function into account. One byte per brick of BrickRanges:
///   0            structured: sample it
///   1            homogeneous: one sample stands for the whole brick
///   128 + k      invisible, as are all bricks [b - k, b + k] on each axis, clipped to the volume:
///                a ray may leave this block without a sample. If all rays move the same way along
///                an axis, it is [b, b + k] or [b - k, b]; behind a surface, blocks are then large
///                at once
/// A new transfer function needs a new field, which takes milliseconds; the ranges, which need the
/// whole volume, stay.
struct OpticalField
{
  static constexpr std::uint8_t Structured = 0;
  static constexpr std::uint8_t Homogeneous = 1;
  static constexpr std::uint8_t Invisible = 128;
  static constexpr int LargestRadius = 127;

  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<std::uint8_t> bricks;     ///< x fastest
  int side = BrickRanges::CellsPerSide; ///< cells along each side of a brick

  /// Fraction of the bricks in a box [grid space] that a ray crosses in one step.
  double SkippablePart(const Box& boxGrid) const;
};

/// Limits that make a brick homogeneous. Let s be the extinction [1/mm] and c a colour channel,
/// over all values of the brick:
///   max s - min s <= max(relativeExtinction * min s, opticalDepth / longestRayMm)
///   max c - min c <= color
/// An image drawn with one sample per homogeneous brick then has an error of at most
///   color + 2 (relativeExtinction + opticalDepth)
/// in a premultiplied channel, to first order, for any ray length and any number of bricks
/// (Documentation/Mathematics.md).
struct OpticalTolerance
{
  double relativeExtinction;
  double opticalDepth;
  double color;
  double longestRayMm;

  /// Distributes the largest accepted error of a premultiplied channel over the three limits.
  static OpticalTolerance ForError(double error, double longestRayMm)
  {
    return { error / 8.0, error / 8.0, error / 2.0, longestRayMm };
  }

  /// Makes no brick homogeneous: for images that show more than the values of a brick, such as
  /// shading by its gradients.
  static OpticalTolerance Nothing(double longestRayMm) { return { 0.0, 0.0, -1.0, longestRayMm }; }
};

/// One component of a volume: its values, and the table that the shader looks them up in.
struct OpticalChannel
{
  const BrickRanges& ranges;
  const OpticalTable& table;
  std::uint16_t row = 0; ///< the row of a mask that shows the table; not used without a mask
};

/// Builds the field on all cores. A brick of several channels is invisible if all of them are, and
/// homogeneous if each is homogeneous or invisible. Each may contribute the whole error. Only the
/// channels whose rows occur in a brick count there; others are never seen in it.
/// @param channels  at least one; all of one volume
/// @param rows      the rows of the volume's mask
/// @param towards   ray directions that the field holds for; see DirectionsOf
OpticalField BuildOpticalField(const std::vector<OpticalChannel>& channels, const BrickRows& rows,
  const OpticalTolerance& tolerance, glm::ivec3 towards = glm::ivec3(0));

inline OpticalField BuildOpticalField(const BrickRanges& ranges, const OpticalTable& table,
  const OpticalTolerance& tolerance, glm::ivec3 towards = glm::ivec3(0))
{
  return BuildOpticalField({ OpticalChannel{ ranges, table } }, {}, tolerance, towards);
}

/// A field for isosurfaces: bricks that no surface passes are invisible, all others structured.
OpticalField BuildIsosurfaceField(const BrickRanges& ranges, const std::vector<double>& isovalues,
  glm::ivec3 towards = glm::ivec3(0));

}

#endif
