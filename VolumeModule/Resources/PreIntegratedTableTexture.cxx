#include "Resources/PreIntegratedTableTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <utility>

namespace varimarch
{

void PreIntegratedTableTexture::Upload(vtkOpenGLRenderWindow* window, PreIntegratedTable table)
{
  this->kept = {};
  this->size = table.size;
  this->texture->SetContext(window);
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->texture->Create2DFromRaw(
    unsigned(table.size), unsigned(table.size), 4, VTK_FLOAT, &table.entries.front().x);
}

void PreIntegratedTableTexture::Keep(vtkWindow* window, PreIntegratedTable table)
{
  this->Release(window);
  this->kept = std::move(table);
}

void PreIntegratedTableTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->size = 0;
  this->kept = {};
}

}
