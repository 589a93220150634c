#ifndef Varimarch_VolumeTexture_h
#define Varimarch_VolumeTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace varimarch
{

/// How a texture holds scalars: scalar = texel * scale + offset. Exact for every voxel of 8 and 16
/// bit data and of wider integers whose values span less than 2^16; others keep float's precision
/// relative to their range, wherever it lies.
struct TexelMapping
{
  double scale = 1.0;
  double offset = 0.0;

  double TexelOf(double scalar) const { return (scalar - this->offset) / this->scale; }
};

/// The scalars of a volume as a 3D texture: normalised 16 bit where that is exact, else float.
/// 8 bit data takes 16 bit texels too, because software rasterisers filter 8 bit texels in 8 bit
/// arithmetic, which is off by more than a grey level.
class VolumeTexture
{
public:
  /// Uploads the scalars. A texture of the same size and format is reused.
  /// @param scalars     one component, dimensions.x * dimensions.y * dimensions.z values
  /// @throws std::runtime_error when the device cannot hold the texture
  void Upload(vtkOpenGLRenderWindow* window, vtkDataArray* scalars, glm::ivec3 dimensions);

  vtkTextureObject* Texture() const { return this->texture; }
  const TexelMapping& Mapping() const { return this->mapping; }
  double SmallestScalar() const { return this->smallestScalar; } ///< of the finite values
  double LargestScalar() const { return this->largestScalar; }
  bool AllFinite() const { return this->allFinite; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  TexelMapping mapping;
  double smallestScalar = 0.0;
  double largestScalar = 0.0;
  bool allFinite = true;
  std::size_t bytes = 0;
};

/// Allocates a 3D texture, or says why the device cannot hold it.
/// @param what  the thing it is for, as in "the volume"
/// @throws std::runtime_error naming the limit
void AllocateTexture3D(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  glm::ivec3 dimensions, int vtkType, unsigned int internalFormat, const char* what);

}

#endif
