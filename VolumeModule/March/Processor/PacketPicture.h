#ifndef Varimarch_March_Processor_PacketPicture_h
#define Varimarch_March_Processor_PacketPicture_h

#include "Core/Packets/PacketScene.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// Pictures that the processor marches, in a buffer texture: where OpenGL is software, that is
/// memory which packets write into, so that no pixel is copied.
class PacketPicture
{
public:
  /// @param scenes     a picture of each is made
  /// @param newPixels  part of the pictures
  /// @throws std::runtime_error when there is no memory for them
  void March(vtkOpenGLRenderWindow* window, const std::vector<PacketScene>& scenes,
    const Viewport& newPixels);

  /// Premultiplied RGBA of the pixels that were marched last, row by row, one picture behind the
  /// other.
  vtkTextureObject* Texture() const { return this->texture; }
  const Viewport& Pixels() const { return this->pixels; } ///< that were marched last
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, std::size_t newCount);

  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  std::size_t count = 0; ///< of pixels that there is memory for; only ever grows
  Viewport pixels = {};
};

}

#endif
