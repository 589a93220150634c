#ifndef Varimarch_Resources_VolumeTexture_h
#define Varimarch_Resources_VolumeTexture_h

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Look/ValueRange.h"
#include "Frame/VoxelInput.h"

#include "VarimarchVolumeModule.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

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

/// The texel format of a volume. All its blocks share it, so that they join without a seam.
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
  bool normalized = true; ///< True for 16 bit integers, false for floats.
  bool finite = true;     ///< True if all voxels are known to be finite.

  std::size_t BytesPerTexel() const { return this->normalized ? 2 : 4; }

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
std::vector<ScalarTexels> ScalarTexelsOf(const VoxelComponents& components);

/// The data from which the values of a volume are interpolated: its voxels, or the coefficients of
/// a spline.
struct VoxelValues
{
  VoxelComponents components;
  glm::ivec3 dimensions = glm::ivec3(0);
  std::vector<ScalarTexels> texels =
    std::vector<ScalarTexels>(1); ///< The texel format of each component.
  int reachVoxels = 0; ///< The distance beyond its cell up to which a value depends on voxels.
};

/// A part of the voxels of a volume.
struct ScalarRegion
{
  VoxelComponents components;
  glm::ivec3 dimensions;
  VoxelRegion voxels;
};

/// Voxels as a 3D texture: normalised 16 bit integers if these are exact, otherwise floats. 8 bit
/// data gets 16 bit texels too, because software rasterisers filter 8 bit texels in 8 bit
/// arithmetic, whose error exceeds a grey level.
class VolumeTexture
{
public:
  /// Uploads the scalars of a region. A texture of the same size and format is reused.
  /// @throws std::runtime_error if the device cannot hold the texture
  void Upload(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
    const std::vector<ScalarTexels>& texels);

  /// The number of texels that the device supports in one texture: those of `dimensions`, whose
  /// longest side is halved until the device accepts them. Allocates nothing.
  /// @param dimensions  no side longer than the device allows
  VARIMARCHVOLUME_EXPORT static std::size_t MostTexels(
    glm::ivec3 dimensions, const std::vector<ScalarTexels>& texels);

  vtkTextureObject* Texture() const { return this->texture; }
  bool AllFinite() const { return this->allFinite; } ///< True for the uploaded region.
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  bool allFinite = true;
  std::size_t bytes = 0;
};

/// The texels of the first component of a region, as the numbers that shaders read.
std::vector<float> TexelsAsFloats(const ScalarRegion& region, const ScalarTexels& texels);

/// Allocates a 3D texture.
/// @param components  numbers per texel, 1 to 4
/// @param what  the content of the texture for the error message, such as "a volume"
/// @throws std::runtime_error naming the limit, if the device cannot hold the texture
void AllocateTexture3D(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  glm::ivec3 dimensions, int vtkType, unsigned int internalFormat, int components,
  const char* what);

}

#endif
