#include "OpticalTableTexture.h"

#include <utility>

namespace varimarch
{

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, OpticalTable newTable)
{
  this->texture.Upload(window, newTable.entries);
  this->table = std::move(newTable);
  this->visibleValues = varimarch::VisibleValues(this->table);
}

void OpticalTableTexture::Release(vtkWindow* window)
{
  this->texture.Release(window);
  this->table = {};
}

}
