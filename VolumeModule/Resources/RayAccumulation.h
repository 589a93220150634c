#ifndef Varimarch_Resources_RayAccumulation_h
#define Varimarch_Resources_RayAccumulation_h

#include "Resources/FloatFramebuffer.h"

namespace varimarch
{

/// The sums that the rays of an image have gathered so far, four floats for each ray. Each block of
/// a volume continues the sums of the blocks in front of it.
class RayAccumulation
{
public:
  /// The memory of an image of this size.
  static std::size_t BytesFor(const Viewport& pixels);

  /// Calls `draw` with an empty accumulation bound as framebuffer. It has the size of `pixels` and
  /// its origin at (0, 0).
  /// @throws std::runtime_error if OpenGL has no framebuffer of floats
  void Draw(
    vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw);

  /// Copies the given pixels to Drawn(), because a texture cannot be read while it is drawn to.
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
