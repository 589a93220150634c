#ifndef Varimarch_Resources_BlueNoiseTexture_h
#define Varimarch_Resources_BlueNoiseTexture_h

#include "Core/Parameters/MarchTextures.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A tile of 16 bit blue noise, which offsets the first sample of each ray. It is uploaded only if
/// shaders read it.
class BlueNoiseTexture
{
public:
  static constexpr int Pixels = 64; ///< The number of pixels on a side.

  /// Makes the tile unless it exists.
  void MakeTile();

  /// Uploads the tile to the device. Requires MakeTile().
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseTexture(vtkWindow* window);

  MarchTexture Texture() const
  {
    return { this->texture, this->tile.empty() ? nullptr : this->tile.data() };
  }
  std::size_t Bytes() const { return this->texture->GetHandle() ? 2 * Pixels * Pixels : 0; }
  void Release(vtkWindow* window);

private:
  std::vector<std::uint16_t> tile;
  vtkNew<vtkTextureObject> texture;
};

}

#endif
