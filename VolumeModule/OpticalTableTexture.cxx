#include "OpticalTableTexture.h"

#include <utility>

namespace varimarch
{

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, std::vector<OpticalTable> newTables)
{
  std::vector<glm::vec4> entries;
  this->visibleValues.clear();
  for (const OpticalTable& table : newTables)
  {
    this->visibleValues.push_back(varimarch::VisibleValues(table));
    entries.insert(entries.end(), table.entries.begin(), table.entries.end());
  }
  this->texture.Upload(window, entries);
  this->tables = std::move(newTables);
}

std::size_t OpticalTableTexture::FirstEntryOf(std::size_t table) const
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < table; ++i)
  {
    first += this->tables[i].entries.size();
  }
  return first;
}

void OpticalTableTexture::Release(vtkWindow* window)
{
  this->texture.Release(window);
  this->tables = { OpticalTable() };
}

}
