#ifndef Varimarch_Resources_BlueNoiseTexture_h
#define Varimarch_Resources_BlueNoiseTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A tile of blue noise of 16 bits: where rays have their first sample. On the device it is where
/// shaders read it.
class BlueNoiseTexture
{
public:
  static constexpr int Pixels = 64; ///< on a side

  /// Makes the tile unless it is there.
  void MakeTile();
  const std::vector<std::uint16_t>& Tile() const { return this->tile; } ///< after MakeTile

  /// Has the tile, which has been made, on the device.
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseTexture(vtkWindow* window);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const { return this->texture->GetHandle() ? 2 * Pixels * Pixels : 0; }
  void Release(vtkWindow* window);

private:
  std::vector<std::uint16_t> tile;
  vtkNew<vtkTextureObject> texture;
};

}

#endif
