#ifndef Varimarch_Resources_GradientTexture_h
#define Varimarch_Resources_GradientTexture_h

#include "Resources/VolumeTexture.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The gradients of the first component as a 3D texture: for each voxel the differences between the
/// texels one voxel to either side. Three numbers of 16 bits, normalised if the volume's texels
/// are, otherwise floats.
class GradientTexture
{
public:
  static constexpr std::size_t BytesPerVoxel = 3 * 2;

  /// Computes and uploads the gradients of a region. A texture of the same size and format is
  /// reused.
  /// @param texels  format of the first component
  /// @throws std::runtime_error if the device cannot hold the texture
  void Upload(
    vtkOpenGLRenderWindow* window, const ScalarRegion& region, const ScalarTexels& texels);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  std::size_t bytes = 0;
};

}

#endif
