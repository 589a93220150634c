#ifndef Varimarch_BlueNoiseTexture_h
#define Varimarch_BlueNoiseTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A tile of blue noise as 16 bit texels: where rays have their first sample.
class BlueNoiseTexture
{
public:
  static constexpr int Pixels = 64; ///< on a side

  /// Makes and uploads the tile unless it is there.
  void Update(vtkOpenGLRenderWindow* window);

  const std::vector<std::uint16_t>& Tile() const { return this->tile; } ///< after Update

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const { return this->texture->GetHandle() ? 2 * Pixels * Pixels : 0; }
  void Release(vtkWindow* window);

private:
  std::vector<std::uint16_t> tile;
  vtkNew<vtkTextureObject> texture;
};

}

#endif
