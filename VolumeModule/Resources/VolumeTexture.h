#ifndef Varimarch_Resources_VolumeTexture_h
#define Varimarch_Resources_VolumeTexture_h

#include "Core/Geometry/ScalarGrid.h"
#include "Frame/VoxelInput.h"
#include "Resources/ScalarTexels.h"

#include "VarimarchVolumeModule.h"
#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

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

/// Voxels as a 3D texture.
class VolumeTexture
{
public:
  /// Uploads the scalars of a region. A texture of the same size and format is reused.
  /// @throws std::runtime_error if the device cannot hold the texture
  void Upload(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
    const std::vector<ScalarTexels>& texels, TexelFormat format);

  /// The number of texels that the device supports in one texture: those of `dimensions`, whose
  /// longest side is halved until the device accepts them. Allocates nothing.
  /// @param dimensions  no side longer than the device allows
  VARIMARCHVOLUME_EXPORT static std::size_t MostTexels(
    glm::ivec3 dimensions, std::size_t components, TexelFormat format);

  vtkTextureObject* Texture() const { return this->texture; }
  bool AllFinite() const { return this->allFinite; } ///< True for the uploaded region.
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  bool allFinite = true;
  std::size_t bytes = 0;
};

/// Sets linear filtering that continues a texture beyond its outermost voxels.
/// @param isNarrow  true for texels of 8 bits or less
VARIMARCHVOLUME_EXPORT void SetVolumeFilter(vtkTextureObject* texture, bool isNarrow);

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
