#ifndef Varimarch_March_Processor_TranslucentColors_h
#define Varimarch_March_Processor_TranslucentColors_h

#include "Frame/Frame.h"
#include "Resources/SceneDepthTexture.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The light that translucent geometry adds to the colours behind it. VTK blends translucent
/// geometry over opaque geometry before it draws volumes, and blending is linear in the colour
/// behind: if opaque geometry keeps a factor f of its light, then a colour F in the framebuffer, to
/// which translucent geometry has added C, becomes f F + (1 - f) C.
class TranslucentColors
{
public:
  /// Draws the translucent geometry of a renderer again, over black, behind the same opaque depths.
  /// It draws no volumes.
  /// @returns C for each pixel of the depths, row by row from below
  std::vector<glm::vec4> Draw(const FrameView& view, const SceneDepthTexture& depth);

  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, const SceneDepthTexture& depth);

  vtkNew<vtkTextureObject> color;
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
};

}

#endif
