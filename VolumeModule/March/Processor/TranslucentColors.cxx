#include "March/Processor/TranslucentColors.h"

#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkType.h"

#include <stdexcept>

namespace varimarch
{

std::vector<glm::vec4> TranslucentColors::Draw(
  const FrameView& view, const SceneDepthTexture& depth)
{
  const glm::ivec2 pixels = depth.SizePixels();
  vtkOpenGLState* const state = view.window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  std::vector<glm::vec4> colors(std::size_t(pixels.x) * std::size_t(pixels.y));
  state->PushFramebufferBindings();
  this->Bind(view.window, depth);
  state->vtkglViewport(0, 0, pixels.x, pixels.y);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  view.renderer->DeviceRenderTranslucentPolygonalGeometry(this->framebuffer);
  this->framebuffer->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, pixels.x, pixels.y, GL_RGBA, GL_FLOAT, &colors.front().x);
  state->PopFramebufferBindings();
  return colors;
}

void TranslucentColors::Bind(vtkOpenGLRenderWindow* window, const SceneDepthTexture& depth)
{
  const glm::ivec2 pixels = depth.SizePixels();
  this->framebuffer->SetContext(window);
  this->color->SetContext(window);
  if (!this->color->GetHandle() || int(this->color->GetWidth()) != pixels.x ||
    int(this->color->GetHeight()) != pixels.y)
  {
    this->color->Allocate2D(unsigned(pixels.x), unsigned(pixels.y), 4, VTK_FLOAT);
  }
  this->framebuffer->Bind();
  this->framebuffer->AddColorAttachment(0, this->color);
  this->framebuffer->AddDepthAttachment(depth.Texture().onDevice);
  this->framebuffer->Resize(pixels.x, pixels.y); // VTK's passes ask for the size
  this->framebuffer->ActivateDrawBuffer(0);
}

std::size_t TranslucentColors::Bytes() const
{
  const std::size_t pixels = std::size_t(this->color->GetWidth()) * this->color->GetHeight();
  return this->color->GetHandle() ? 4 * sizeof(float) * pixels : 0;
}

void TranslucentColors::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
}

}
