#include "PacketPicture.h"

#include "Core/Packets/PacketMarch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <algorithm>

namespace varimarch
{

void PacketPicture::March(
  vtkOpenGLRenderWindow* window, const PacketScene& scene, const Viewport& newPixels)
{
  this->pixels = newPixels;
  this->rgba.resize(4 * std::size_t(this->pixels.width) * this->pixels.height);
  MarchPackets(scene, this->pixels, this->rgba.data());

  const auto width = unsigned(this->pixels.width);
  const auto height = unsigned(this->pixels.height);
  if (this->texture->GetWidth() < width || this->texture->GetHeight() < height)
  {
    const unsigned newWidth = std::max(this->texture->GetWidth(), width);
    const unsigned newHeight = std::max(this->texture->GetHeight(), height);
    this->texture->SetContext(window);
    this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->texture->Allocate2D(newWidth, newHeight, 4, VTK_FLOAT);
  }
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, this->pixels.width, this->pixels.height, GL_RGBA,
    GL_FLOAT, this->rgba.data());
  this->texture->Deactivate();
}

std::size_t PacketPicture::Bytes() const
{
  return this->texture->GetHandle()
    ? 4 * sizeof(float) * std::size_t(this->texture->GetWidth()) * this->texture->GetHeight()
    : 0;
}

void PacketPicture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->rgba = {};
}

}
