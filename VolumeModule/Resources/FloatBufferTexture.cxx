#include "Resources/FloatBufferTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

namespace varimarch
{

void FloatBufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& entries)
{
  this->buffer->Upload(
    &entries.front().x, 4 * entries.size(), vtkOpenGLBufferObject::TextureBuffer);
  if (entries.size() != this->count)
  {
    this->texture->ReleaseGraphicsResources(window);
    this->texture->SetContext(window);
    this->texture->CreateTextureBuffer(unsigned(entries.size()), 4, VTK_FLOAT, this->buffer);
    this->count = entries.size();
  }
}

void FloatBufferTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->buffer->ReleaseGraphicsResources();
  this->count = 0;
}

}
