#include "Resources/SceneDepthTexture.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"

namespace varimarch
{

namespace
{

// The depth format of the framebuffer that is bound for drawing. A blit needs the same format.
GLenum BoundDepthFormat()
{
  const auto parameter = [](GLenum name)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name, &value);
    return value;
  };
  const GLint bits = parameter(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  const bool stencil = parameter(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  if (parameter(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  switch (bits)
  {
    case 16:
      return GL_DEPTH_COMPONENT16;
    case 32:
      return GL_DEPTH_COMPONENT32;
  }
  return stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
}

}

void SceneDepthTexture::Capture(
  vtkOpenGLRenderWindow* window, int left, int bottom, int width, int height)
{
  const GLenum boundFormat = BoundDepthFormat();
  if (!this->depth->GetHandle() || this->format != boundFormat)
  {
    this->Release(window);
    this->format = boundFormat;
    this->Allocate(window, width, height);
  }
  this->depths.clear();
  this->depth->Resize(width, height);
  this->color->Resize(width, height);
  this->bytes = std::size_t(width) * height * 5; // 4 of depth, with its stencil, and 1 of colour

  vtkOpenGLState* state = window->GetState();
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(source));
  this->framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->framebuffer->AddDepthAttachment(this->depth);
  this->framebuffer->AddColorAttachment(0, this->color);
  state->vtkglBlitFramebuffer(left, bottom, left + width, bottom + height, 0, 0, width, height,
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

void SceneDepthTexture::Read(vtkOpenGLRenderWindow* window)
{
  if (!this->depths.empty())
  {
    return;
  }
  const auto width = GLsizei(this->depth->GetWidth());
  const auto height = GLsizei(this->depth->GetHeight());
  this->depths.resize(std::size_t(width) * height);
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  this->framebuffer->Bind(GL_READ_FRAMEBUFFER);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, this->depths.data());
  state->PopFramebufferBindings();
}

void SceneDepthTexture::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->depth->SetContext(window);
  this->depth->SetMinificationFilter(vtkTextureObject::Nearest);
  this->depth->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->depth->ResetFormatAndType();
  this->depth->SetInternalFormat(this->format);
  const bool stencil = this->format == GL_DEPTH24_STENCIL8 || this->format == GL_DEPTH32F_STENCIL8;
  stencil ? this->depth->AllocateDepthStencil(width, height)
          : this->depth->AllocateDepth(width, height, vtkTextureObject::Fixed32);
  this->color->SetContext(window);
  this->color->Allocate2D(width, height, 1, VTK_UNSIGNED_CHAR);
  this->framebuffer->SetContext(window);
}

void SceneDepthTexture::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->depth->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
  this->depths.clear();
  this->bytes = 0;
}

}
