#include "Resources/FloatFramebuffer.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

void Allocate(
  vtkTextureObject* texture, vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height)
{
  texture->SetContext(window);
  if (!texture->GetHandle() || texture->GetWidth() != width || texture->GetHeight() != height)
  {
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Allocate2D(width, height, 4, VTK_FLOAT);
  }
}

}

FloatFramebuffer::FloatFramebuffer(int outputs)
{
  for (int output = 0; output < outputs; ++output)
  {
    this->textures.push_back(vtkSmartPointer<vtkTextureObject>::New());
  }
}

std::size_t FloatFramebuffer::BytesFor(const Viewport& pixels)
{
  return 4 * sizeof(float) * pixels.width * pixels.height;
}

void FloatFramebuffer::Draw(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  this->DrawMore(window, pixels,
    [&]
    {
      vtkOpenGLState* const state = window->GetState();
      const vtkOpenGLState::ScopedglClearColor clearColor(state);
      state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
      state->vtkglClear(GL_COLOR_BUFFER_BIT);
      draw();
    });
}

void FloatFramebuffer::DrawMore(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  try
  {
    this->Bind(window, pixels);
    state->vtkglViewport(0, 0, pixels.width, pixels.height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    draw();
  }
  catch (...)
  {
    state->PopFramebufferBindings();
    throw;
  }
  state->PopFramebufferBindings();
}

std::vector<float> FloatFramebuffer::Read(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, int output)
{
  std::vector<float> rgba(4 * std::size_t(pixels.width) * pixels.height);
  window->MakeCurrent();
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  this->Bind(window, pixels);
  this->framebuffer->ActivateReadBuffer(output);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, pixels.width, pixels.height, GL_RGBA, GL_FLOAT, rgba.data());
  state->PopFramebufferBindings();
  return rgba;
}

void FloatFramebuffer::Bind(vtkOpenGLRenderWindow* window, const Viewport& pixels)
{
  const unsigned int width = std::max(this->Texture()->GetWidth(), unsigned(pixels.width));
  const unsigned int height = std::max(this->Texture()->GetHeight(), unsigned(pixels.height));
  this->framebuffer->SetContext(window);
  for (vtkTextureObject* texture : this->textures)
  {
    Allocate(texture, window, width, height);
  }
  this->framebuffer->Bind();
  for (std::size_t output = 0; output < this->textures.size(); ++output)
  {
    this->framebuffer->AddColorAttachment(output, this->textures[output]);
  }
  this->framebuffer->ActivateDrawBuffers(this->textures.size());
  if (!this->framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    throw std::runtime_error(
      "OpenGL has no framebuffer of 32 bit floats, which an error tolerance, "
      "blocks, and an image sample distance other than 1 need");
  }
}

std::size_t FloatFramebuffer::Bytes() const
{
  const std::size_t pixels =
    std::size_t(this->Texture()->GetWidth()) * this->Texture()->GetHeight();
  return this->Texture()->GetHandle() ? 4 * sizeof(float) * pixels * this->textures.size() : 0;
}

void FloatFramebuffer::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  for (vtkTextureObject* texture : this->textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
}

}
