#include "Resources/FloatTable.h"

#include "vtkOpenGLRenderWindow.h"

#include <utility>

namespace varimarch
{

void FloatTable::Set(vtkWindow* window, std::vector<glm::vec4> newEntries)
{
  this->texture.Release(window);
  this->entries = std::move(newEntries);
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
