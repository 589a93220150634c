#ifndef Varimarch_March_RayAccumulation_h
#define Varimarch_March_RayAccumulation_h

#include "Resources/FloatFramebuffer.h"

namespace varimarch
{

/// What the rays of a picture have gathered so far, as four floats for each: where a volume is
/// drawn block by block, each block goes on where those in front of it have ended.
class RayAccumulation
{
public:
  /// What a picture of this size takes.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Calls `draw` with an empty accumulation bound as framebuffer. It covers `pixels`, whose
  /// origin is (0, 0).
  /// @throws std::runtime_error when OpenGL has no framebuffer of floats
  void Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Makes what has been drawn so far in a part of the pixels readable as Drawn(): a texture is not
  /// read while it is drawn to.
  void Keep(const Viewport& part);

  vtkTextureObject* Drawn() const { return this->kept; }
  vtkTextureObject* Finished() const { return this->target.Texture(); } ///< after Draw
  std::size_t Bytes() const { return 2 * this->target.Bytes(); }
  void Release(vtkWindow* window);

private:
  void AllocateKept(vtkOpenGLRenderWindow* window);

  FloatFramebuffer target;
  vtkNew<vtkTextureObject> kept;
};

}

#endif
