#ifndef Varimarch_March_Processor_PacketPicture_h
#define Varimarch_March_Processor_PacketPicture_h

#include "Core/Packets/PacketScene.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

class MarchWork;

/// Images that the processor marches, in a buffer texture. If OpenGL is software, packets write
/// directly into the texture's memory, so that no pixel is copied.
class PacketPicture
{
public:
  /// @param scenes     one for each image
  /// @param newPixels  the part of the images that is marched
  /// @throws std::runtime_error if memory does not suffice
  /// @param work       see MarchPackets
  void March(vtkOpenGLRenderWindow* window, const std::vector<PacketScene>& scenes,
    const Viewport& newPixels, MarchWork* work);

  /// Takes an image that was computed in another way.
  void Take(
    vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& rgba, const Viewport& newPixels);

  /// Premultiplied RGBA of the pixels that were marched last, row by row and image by image.
  vtkTextureObject* Texture() const { return this->texture; }
  const Viewport& Pixels() const { return this->pixels; } ///< The pixels that were marched last.
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Write(vtkOpenGLRenderWindow* window, std::size_t newCount,
    const std::function<void(float* rgba)>& write);
  void Allocate(vtkOpenGLRenderWindow* window, std::size_t newCount);

  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  std::size_t count = 0; ///< The capacity [pixels], which only grows.
  Viewport pixels = {};
};

}

#endif
