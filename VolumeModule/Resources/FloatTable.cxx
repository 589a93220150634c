#include "Resources/FloatTable.h"

#include "vtkOpenGLRenderWindow.h"

#include <utility>

namespace varimarch
{

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
