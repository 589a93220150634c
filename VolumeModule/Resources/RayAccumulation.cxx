#include "Resources/RayAccumulation.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

namespace varimarch
{

std::size_t RayAccumulation::BytesFor(const Viewport& pixels)
{
  return 2 * FloatFramebuffer::BytesFor(pixels);
}

void RayAccumulation::Draw(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  this->target.Draw(window, pixels,
    [&]
    {
      this->AllocateKept(window);
      draw();
    });
}

void RayAccumulation::AllocateKept(vtkOpenGLRenderWindow* window)
{
  const unsigned int width = this->target.Texture()->GetWidth();
  const unsigned int height = this->target.Texture()->GetHeight();
  this->kept->SetContext(window);
  if (!this->kept->GetHandle() || this->kept->GetWidth() != width ||
    this->kept->GetHeight() != height)
  {
    this->kept->SetMinificationFilter(vtkTextureObject::Nearest);
    this->kept->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->kept->Allocate2D(width, height, 4, VTK_FLOAT);
  }
}

void RayAccumulation::Keep(const Viewport& part)
{
  this->kept->Activate();
  glCopyTexSubImage2D(
    GL_TEXTURE_2D, 0, part.left, part.bottom, part.left, part.bottom, part.width, part.height);
}

void RayAccumulation::Release(vtkWindow* window)
{
  this->target.Release(window);
  this->kept->ReleaseGraphicsResources(window);
}

}
