#include "SceneDepthTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"
#include "vtk_glew.h"

namespace varimarch
{

void SceneDepthTexture::Capture(
  vtkOpenGLRenderWindow* window, int left, int bottom, int width, int height)
{
  if (!this->depth->GetHandle())
  {
    this->depth->SetContext(window);
    this->depth->SetMinificationFilter(vtkTextureObject::Nearest);
    this->depth->SetMagnificationFilter(vtkTextureObject::Nearest);
    // A blit needs the very format of the source, which VTK chooses by the same test.
    window->GetStencilCapable()
      ? this->depth->AllocateDepthStencil(width, height)
      : this->depth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
    this->color->SetContext(window);
    this->color->Allocate2D(width, height, 1, VTK_UNSIGNED_CHAR);
    this->framebuffer->SetContext(window);
  }
  this->depth->Resize(width, height);
  this->color->Resize(width, height);
  this->bytes = std::size_t(width) * height * 5; // 24 bits of depth, 8 of stencil, 8 of colour

  vtkOpenGLState* state = window->GetState();
  state->PushDrawFramebufferBinding();
  this->framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->framebuffer->AddDepthAttachment(this->depth);
  this->framebuffer->AddColorAttachment(0, this->color);
  state->vtkglBlitFramebuffer(left, bottom, left + width, bottom + height, 0, 0, width, height,
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopDrawFramebufferBinding();
}

void SceneDepthTexture::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->depth->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
