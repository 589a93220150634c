#include "OpticalTableTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <utility>

namespace varimarch
{

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, OpticalTable newTable)
{
  const std::size_t count = newTable.entries.size();
  this->buffer->Upload(
    &newTable.entries.front().x, 4 * count, vtkOpenGLBufferObject::TextureBuffer);
  if (count != this->table.entries.size())
  {
    this->texture->ReleaseGraphicsResources(window);
    this->texture->SetContext(window);
    this->texture->CreateTextureBuffer(unsigned(count), 4, VTK_FLOAT, this->buffer);
  }
  this->table = std::move(newTable);
  this->visibleValues = varimarch::VisibleValues(this->table);
}

void OpticalTableTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->buffer->ReleaseGraphicsResources();
  this->table = {};
}

}
