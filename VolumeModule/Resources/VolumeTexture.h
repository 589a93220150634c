#ifndef Varimarch_Resources_VolumeTexture_h
#define Varimarch_Resources_VolumeTexture_h

#include "Core/Geometry/ScalarGrid.h"
#include "Frame/VoxelInput.h"

#include "VarimarchVolumeModule.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The scalars of texels: scalar = texel * scale + offset. It is exact for every voxel of 8 and 16
/// bit data and of wider integers whose values span less than 2^16; other numbers keep the
/// precision of floats relative to their range, wherever it lies.
struct TexelMapping
{
  double scale = 1.0;
  double offset = 0.0;

  double TexelOf(double scalar) const { return (scalar - this->offset) / this->scale; }

  /// A texel within the range of floats, for scalars that may be infinite. VTK's endless range is
  /// about that of floats.
  double LimitedTexelOf(double scalar) const;
};

/// The format that all textures of a volume share, so that their images meet without a seam.
struct ScalarTexels
{
  double smallestScalar = 0.0; ///< The range of the finite voxels.
  double largestScalar = 0.0;
  double smallestValue = 0.0; ///< The bounds of interpolated values, which may exceed the voxels.
  double largestValue = 0.0;
  TexelMapping mapping;
  bool normalized = true; ///< 16 bit integers; otherwise floats.
  bool finite = true;     ///< True if all voxels are known to be finite.

  std::size_t BytesPerTexel() const { return this->normalized ? 2 : 4; }
};

/// The largest gradient, per mean spacing, that VTK tells from larger ones: a quarter of the range.
inline double LargestGradient(const ScalarTexels& texels)
{
  const double range = texels.largestScalar - texels.smallestScalar;
  return 0.25 * (range > 0.0 ? range : 1.0);
}

/// The format of each component, for linear interpolation. All of them are normalized, or none is.
std::vector<ScalarTexels> ScalarTexelsOf(const VoxelComponents& components);

/// The numbers that the values of a volume are interpolated from: its voxels, or the coefficients
/// of a spline.
struct VoxelValues
{
  VoxelComponents components;
  glm::ivec3 dimensions = glm::ivec3(0);
  std::vector<ScalarTexels> texels = { ScalarTexels() }; ///< One for each component.
  int reachVoxels = 0; ///< The distance beyond its cell from which a value depends on them.
};

/// A part of the voxels of a volume.
struct ScalarRegion
{
  VoxelComponents components;
  glm::ivec3 dimensions;
  VoxelRegion voxels;
};

/// Voxels as a 3D texture: normalised 16 bit integers if they are exact, otherwise floats. 8 bit
/// data takes 16 bit texels too, because software rasterisers filter 8 bit texels in 8 bit
/// arithmetic, which is off by more than a grey level.
class VolumeTexture
{
public:
  /// Uploads the scalars of a region. A texture of the same size and format is reused.
  /// @throws std::runtime_error if the device cannot hold the texture
  void Upload(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
    const std::vector<ScalarTexels>& texels);

  /// How many texels the device takes in one texture: as many as `dimensions`, or as are left when
  /// their longest side is halved until it does. A question only; nothing is allocated.
  /// @param dimensions  no longer than a side may be
  VARIMARCHVOLUME_EXPORT static std::size_t MostTexels(
    glm::ivec3 dimensions, const std::vector<ScalarTexels>& texels);

  vtkTextureObject* Texture() const { return this->texture; }
  bool AllFinite() const { return this->allFinite; } ///< in the region
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  bool allFinite = true;
  std::size_t bytes = 0;
};

/// Allocates a 3D texture, or says why the device cannot hold it.
/// @param components  numbers per texel, 1 to 4
/// @param what  the purpose of the texture, as in "the volume"
/// @throws std::runtime_error naming the limit
void AllocateTexture3D(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  glm::ivec3 dimensions, int vtkType, unsigned int internalFormat, int components,
  const char* what);

}

#endif
