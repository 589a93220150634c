// How a frame is drawn, when all its uniforms are set: as the inner faces of a box.

#include "March/RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/matrix.hpp>

namespace varimarch
{

namespace
{

enum class Blending
{
  Over,    ///< what is there
  Replace, ///< it
  Add,     ///< to it
  AsSet    ///< by who asks for the drawing
};

Blending BlendingOf(const Frame& frame)
{
  const RayPass pass = frame.settings.pass;
  if (frame.settings.role == ShaderRole::WriteLayerDepths)
  {
    return Blending::Replace;
  }
  if (Peels(pass))
  {
    return Blending::AsSet;
  }
  if (pass == RayPass::Block || Picks(pass))
  {
    return Blending::Replace;
  }
  return frame.addsUp ? Blending::Add : Blending::Over;
}

// Restores what drawing the box changes.
class BoxDrawingState
{
public:
  BoxDrawingState(vtkOpenGLState* state, bool mirrored, Blending blending)
    : depthTest(state, GL_DEPTH_TEST)
    , blend(state, GL_BLEND)
    , cullFace(state, GL_CULL_FACE)
    , depthMask(state)
    , blendFunction(state)
    , state(state)
    , depthClamp(glIsEnabled(GL_DEPTH_CLAMP))
  {
    state->vtkglGetIntegerv(GL_CULL_FACE_MODE, &this->cullFaceMode);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    if (blending != Blending::AsSet)
    {
      const GLenum factor = blending == Blending::Add ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA;
      state->SetEnumState(GL_BLEND, blending != Blending::Replace);
      state->vtkglBlendFuncSeparate(GL_ONE, factor, GL_ONE, factor);
    }
    // The inner sides of the box: there is one behind every pixel, also from within.
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(mirrored ? GL_BACK : GL_FRONT);
    // The far plane must not cut the box that only stands for its pixels.
    glEnable(GL_DEPTH_CLAMP);
  }

  ~BoxDrawingState()
  {
    if (!this->depthClamp)
    {
      glDisable(GL_DEPTH_CLAMP);
    }
    this->state->vtkglCullFace(GLenum(this->cullFaceMode));
  }

private:
  vtkOpenGLState::ScopedglEnableDisable depthTest;
  vtkOpenGLState::ScopedglEnableDisable blend;
  vtkOpenGLState::ScopedglEnableDisable cullFace;
  vtkOpenGLState::ScopedglDepthMask depthMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction;
  vtkOpenGLState* state;
  GLboolean depthClamp;
  GLint cullFaceMode = GL_BACK;
};

}

void RayMarcher::DrawBox(const Frame& frame, const DrawnBlock& drawn)
{
  this->SetParameters(frame, drawn);
  {
    const bool mirrored = glm::determinant(frame.geometry.WorldFromGridDirection()) < 0.0;
    const BoxDrawingState drawing(frame.window->GetState(), mirrored, BlendingOf(frame));
    this->boxGeometry.Draw(this->program.Program(), drawn.coverGrid);
  }
  this->program.DeactivateTextures();
}

}
