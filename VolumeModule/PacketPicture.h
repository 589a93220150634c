#ifndef Varimarch_PacketPicture_h
#define Varimarch_PacketPicture_h

#include "Core/Packets/PacketScene.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A picture that the processor marches, as a texture.
class PacketPicture
{
public:
  /// @param newPixels  part of the picture
  void March(vtkOpenGLRenderWindow* window, const PacketScene& scene, const Viewport& newPixels);

  /// Premultiplied RGBA of the pixels that were marched last, the first of them at (0, 0).
  vtkTextureObject* Texture() const { return this->texture; }
  const Viewport& Pixels() const { return this->pixels; } ///< that were marched last
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture; ///< only ever grows
  Viewport pixels = {};
  std::vector<float> rgba;
};

}

#endif
