#include "RayAccumulation.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

std::size_t RayAccumulation::BytesFor(const Viewport& pixels)
{
  return 2 * 4 * sizeof(float) * pixels.width * pixels.height;
}

void RayAccumulation::Draw(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  try
  {
    this->Allocate(window, pixels);
    state->vtkglViewport(0, 0, pixels.width, pixels.height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    draw();
  }
  catch (...)
  {
    state->PopFramebufferBindings();
    throw;
  }
  state->PopFramebufferBindings();
}

void RayAccumulation::Allocate(vtkOpenGLRenderWindow* window, const Viewport& pixels)
{
  this->framebuffer->SetContext(window);
  // Only ever larger: a picture is tried out with fewer pixels before it is drawn.
  const unsigned int width = std::max(this->target->GetWidth(), unsigned(pixels.width));
  const unsigned int height = std::max(this->target->GetHeight(), unsigned(pixels.height));
  for (vtkTextureObject* texture : { this->target.Get(), this->kept.Get() })
  {
    texture->SetContext(window);
    if (!texture->GetHandle() || texture->GetWidth() != width || texture->GetHeight() != height)
    {
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      texture->Allocate2D(width, height, 4, VTK_FLOAT);
    }
  }
  this->framebuffer->Bind();
  this->framebuffer->AddColorAttachment(0, this->target);
  this->framebuffer->ActivateDrawBuffer(0);
  this->framebuffer->ActivateReadBuffer(0);
  if (!this->framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    throw std::runtime_error("OpenGL offers no framebuffer of 32 bit floats, which a volume drawn "
                             "in blocks needs");
  }
}

void RayAccumulation::Keep(const Viewport& part)
{
  this->kept->Activate();
  glCopyTexSubImage2D(
    GL_TEXTURE_2D, 0, part.left, part.bottom, part.left, part.bottom, part.width, part.height);
}

std::size_t RayAccumulation::Bytes() const
{
  const std::size_t pixels = std::size_t(this->target->GetWidth()) * this->target->GetHeight();
  return this->target->GetHandle() ? 2 * 4 * sizeof(float) * pixels : 0;
}

void RayAccumulation::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->target->ReleaseGraphicsResources(window);
  this->kept->ReleaseGraphicsResources(window);
}

}
