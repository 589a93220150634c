#include "March/Device/OpaqueFramebuffer.h"

#include "Frame/VolumeGeometry.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

namespace varimarch
{

OpaqueFramebuffer::OpaqueFramebuffer(vtkRenderer* renderer)
  : state(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState())
  , viewport(state)
{
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->layers);
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->blendEquation);
  this->state->PopDrawFramebufferBinding();
  this->state->vtkglBlendEquation(GL_FUNC_ADD);
  const Viewport pixels = ViewportOf(renderer);
  this->state->vtkglViewport(pixels.left, pixels.bottom, pixels.width, pixels.height);
}

OpaqueFramebuffer::~OpaqueFramebuffer()
{
  this->state->vtkglBlendEquation(GLenum(this->blendEquation));
  this->state->PushDrawFramebufferBinding();
  this->state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(this->layers));
}

}
