#include "ProbeFramebuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

Viewport ProbeFramebuffer::PixelsFor(const Viewport& picture)
{
  return { 0, 0, std::min(picture.width, 96), std::min(picture.height, 48) };
}

std::vector<float> ProbeFramebuffer::Draw(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  std::vector<float> rgba(4 * std::size_t(pixels.width) * pixels.height);
  state->PushFramebufferBindings();
  try
  {
    this->Bind(window, pixels);
    state->vtkglViewport(0, 0, pixels.width, pixels.height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    draw();
    state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, pixels.width, pixels.height, GL_RGBA, GL_FLOAT, rgba.data());
  }
  catch (...)
  {
    state->PopFramebufferBindings();
    throw;
  }
  state->PopFramebufferBindings();
  return rgba;
}

void ProbeFramebuffer::Bind(vtkOpenGLRenderWindow* window, const Viewport& pixels)
{
  if (this->width == pixels.width && this->height == pixels.height)
  {
    this->framebuffer->Bind();
    return;
  }
  this->framebuffer->SetContext(window);
  if (!this->framebuffer->PopulateFramebuffer(
        pixels.width, pixels.height, true, 1, VTK_FLOAT, false, 0, 0))
  {
    throw std::runtime_error("OpenGL offers no framebuffer of 32 bit floats, which an error "
                             "tolerance needs: set it to 0, and a sample distance");
  }
  this->width = pixels.width;
  this->height = pixels.height;
  this->bytes = 4 * sizeof(float) * std::size_t(pixels.width) * pixels.height;
}

void ProbeFramebuffer::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->width = 0;
  this->height = 0;
  this->bytes = 0;
}

}
