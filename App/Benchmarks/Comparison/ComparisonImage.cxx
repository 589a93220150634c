#include "ComparisonImage.h"

#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <stdexcept>

namespace varimarch
{

void ComparisonImage::Begin(vtkOpenGLRenderWindow* window, glm::ivec2 newSize,
  const glm::vec4& clear, vtkTextureObject* depth)
{
  if (this->size != newSize || !this->color->GetHandle())
  {
    this->size = newSize;
    this->color->ReleaseGraphicsResources(window);
    this->color->SetContext(window);
    this->color->SetMinificationFilter(vtkTextureObject::Linear);
    this->color->SetMagnificationFilter(vtkTextureObject::Linear);
    this->color->SetWrapS(vtkTextureObject::ClampToEdge);
    this->color->SetWrapT(vtkTextureObject::ClampToEdge);
    this->color->Allocate2D(unsigned(newSize.x), unsigned(newSize.y), 4, VTK_FLOAT);
  }
  this->framebuffer->SetContext(window);
  this->framebuffer->Bind();
  this->framebuffer->AddColorAttachment(0, this->color);
  if (depth)
  {
    this->framebuffer->AddDepthAttachment(depth);
  }
  else
  {
    this->framebuffer->RemoveDepthAttachment();
  }
  this->framebuffer->ActivateDrawBuffers(1);
  if (!this->framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    throw std::runtime_error("A comparison method needs a framebuffer of 32 bit floats, and OpenGL "
                             "has none of " +
      std::to_string(newSize.x) + " x " + std::to_string(newSize.y) + " pixels");
  }
  this->Continue(window);
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  state->vtkglClearColor(clear.r, clear.g, clear.b, clear.a);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

void ComparisonImage::Continue(vtkOpenGLRenderWindow* window)
{
  this->framebuffer->Bind();
  window->GetState()->vtkglViewport(0, 0, this->size.x, this->size.y);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
}

std::size_t ComparisonImage::Bytes() const
{
  return this->color->GetHandle()
    ? 4 * sizeof(float) * std::size_t(this->size.x) * std::size_t(this->size.y)
    : 0;
}

void ComparisonImage::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
}

void SetComparisonState(vtkOpenGLRenderWindow* window, ComparisonBlending blending)
{
  vtkOpenGLState* const state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->SetEnumState(GL_BLEND, blending != ComparisonBlending::Replace);
  switch (blending)
  {
    case ComparisonBlending::Over:
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case ComparisonBlending::Under:
      state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
      break;
    case ComparisonBlending::Dim:
      state->vtkglBlendFuncSeparate(
        GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case ComparisonBlending::Replace:
      break;
  }
}

}
