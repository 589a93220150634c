#include "OpticalTableTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

namespace varimarch
{

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, const OpticalTable& table)
{
  this->buffer->Upload(
    &table.entries.front().x, 4 * table.entries.size(), vtkOpenGLBufferObject::TextureBuffer);
  if (this->entryCount != table.entries.size())
  {
    this->texture->ReleaseGraphicsResources(window);
    this->texture->SetContext(window);
    this->texture->CreateTextureBuffer(unsigned(table.entries.size()), 4, VTK_FLOAT, this->buffer);
  }
  this->entryCount = table.entries.size();
  this->firstValue = table.firstValue;
  this->lastValue = table.lastValue;
}

void OpticalTableTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->buffer->ReleaseGraphicsResources();
  this->entryCount = 0;
}

}
