#include "Resources/FloatTable.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <utility>

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

void FloatTable::Set(vtkWindow* window, std::vector<glm::vec4> newEntries)
{
  if (newEntries != this->entries)
  {
    this->texture.Release(window);
    this->entries = std::move(newEntries);
  }
}

MarchTexture FloatTable::Texture() const
{
  return { this->texture.Texture(), this->entries.empty() ? nullptr : this->entries.data() };
}

void FloatTable::Update(vtkOpenGLRenderWindow* window, Marcher marcher)
{
  if (marcher == Marcher::Processor || this->entries.empty())
  {
    this->texture.Release(window);
  }
  else if (this->texture.Bytes() == 0)
  {
    this->texture.Upload(window, this->entries);
  }
}

}
