#ifndef Varimarch_Resources_RayAccumulation_h
#define Varimarch_Resources_RayAccumulation_h

#include "Resources/FloatFramebuffer.h"

namespace varimarch
{

/// The sums that the rays of an image have gathered so far, four floats for each ray. If a volume
/// is drawn block by block, each block continues where the blocks in front of it have ended.
class RayAccumulation
{
public:
  /// The memory of an image of this size.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Calls `draw` with an empty accumulation bound as framebuffer. It covers `pixels`, whose
  /// origin is (0, 0).
  /// @throws std::runtime_error if OpenGL has no framebuffer of floats
  void Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Makes the drawn part of the pixels readable as Drawn(), because a texture cannot be read while
  /// it is drawn to.
  void Keep(const Viewport& part);

  vtkTextureObject* Drawn() const { return this->kept; }
  vtkTextureObject* Finished() const { return this->target.Texture(); } ///< Valid after Draw.
  std::size_t Bytes() const { return 2 * this->target.Bytes(); }
  void Release(vtkWindow* window);

private:
  void AllocateKept(vtkOpenGLRenderWindow* window);

  FloatFramebuffer target;
  vtkNew<vtkTextureObject> kept;
};

}

#endif
