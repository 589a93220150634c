#ifndef Varimarch_Resources_ScalarTexels_h
#define Varimarch_Resources_ScalarTexels_h

#include "Core/Look/ValueRange.h"
#include "Frame/VoxelInput.h"

#include "VarimarchVolumeModule.h"

#include <cstddef>
#include <vector>

// The numbers by which a volume is stored in a texture.

namespace varimarch
{

/// The mapping from texels to scalars: scalar = texel * scale + offset. It is exact for every voxel
/// of 8 and 16 bit data, and of wider integers whose values span less than 2^16. Other numbers keep
/// the precision of floats relative to their range, even if that is far from zero.
struct TexelMapping
{
  double scale = 1.0;
  double offset = 0.0;

  double TexelOf(double scalar) const { return (scalar - this->offset) / this->scale; }

  /// The texel of a scalar that may be infinite, clamped to the range of floats. VTK's default
  /// range of scalars is about that of floats.
  double LimitedTexelOf(double scalar) const;

  bool operator==(const TexelMapping& other) const
  {
    return this->scale == other.scale && this->offset == other.offset;
  }
};

/// The mapping of numbers that are not normalized. Scales them to about [-1, 1], so that their
/// products do not overflow.
TexelMapping FloatMapping(double smallest, double largest);

/// The numbers that texels are made of: integers that stand for [0, 1], or floats.
enum class TexelFormat
{
  Integers8,
  Integers16,
  Floats,
};

/// The texels of a volume. All its blocks share them, so that they join without a seam.
struct ScalarTexels
{
  double smallestScalar = 0.0; ///< The smallest finite voxel.
  double largestScalar = 0.0;  ///< The largest finite voxel.
  double smallestValue = 0.0;  ///< The lower bound of interpolated values; may be below the voxels.
  double largestValue = 0.0;   ///< The upper bound of interpolated values; may be above the voxels.
  /// The values that tables and fields tell apart: all of them, or those that matter. Values beyond
  /// the ends look like these.
  ValueRange resolved = { 0.0, 0.0 };
  ValueRange gray = { 0.0, 0.0 }; ///< The values that projections show as black and white.
  TexelMapping mapping;
  bool normalized = true; ///< True if integers of 16 bits are exact; otherwise texels are floats.
  bool fits8Bits = false; ///< True if integers of 8 bits are exact too.
  bool finite = true;     ///< True if all voxels are known to be finite.

  bool operator==(const ScalarTexels& other) const
  {
    return this->smallestScalar == other.smallestScalar &&
      this->largestScalar == other.largestScalar && this->smallestValue == other.smallestValue &&
      this->largestValue == other.largestValue && this->resolved == other.resolved &&
      this->gray == other.gray && this->mapping == other.mapping;
  }
  bool operator!=(const ScalarTexels& other) const { return !(*this == other); }
};

/// Texels of floats are limited to this distance from zero if they reach farther, as a fill value
/// does among values that matter, which are about [-1, 1]. Larger texels would shine through where
/// a filter has no weight for them but for rounding. With smaller ones the values that matter would
/// reach visibly into the corners of their cells, where the weights of three axes are multiplied.
constexpr double LargestTexel = 4096.0;

/// The gradient at which VTK's gradient opacity saturates: a quarter of the range per mean spacing.
inline double LargestGradient(const ScalarTexels& texels)
{
  const double range = texels.largestScalar - texels.smallestScalar;
  return 0.25 * (range > 0.0 ? range : 1.0);
}

/// The texel format of each component, for linear interpolation. Either all are normalized or none.
/// @throws std::runtime_error if the scalars of a component differ too little
VARIMARCHVOLUME_EXPORT std::vector<ScalarTexels> ScalarTexelsOf(const VoxelComponents& components);

/// The format of a volume's texels: the narrowest that is exact, where there is one.
/// @param filters8Bits  true if the device filters texels of 8 bits as exactly as wider ones
VARIMARCHVOLUME_EXPORT TexelFormat TexelFormatOf(
  const std::vector<ScalarTexels>& texels, bool filters8Bits);

std::size_t BytesOf(TexelFormat format); ///< Bytes of a component of a texel.

}

#endif
