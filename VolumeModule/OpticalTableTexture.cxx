#include "OpticalTableTexture.h"

#include <utility>

namespace varimarch
{

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, std::vector<OpticalTable> newTables)
{
  this->Upload(window, std::move(newTables), {});
}

void OpticalTableTexture::UploadRows(
  vtkOpenGLRenderWindow* window, std::vector<OpticalTable> newTables, const TexelMapping& mapping)
{
  std::vector<glm::vec4> rows;
  std::size_t first = newTables.size();
  for (const OpticalTable& table : newTables)
  {
    const double last = double(table.entries.size() - 1);
    const double extent = table.lastValue - table.firstValue;
    const double indexPerValue = extent > 0.0 ? last / extent : 0.0;
    rows.emplace_back(mapping.scale * indexPerValue,
      (mapping.offset - table.firstValue) * indexPerValue, double(first), last);
    first += table.entries.size();
  }
  this->Upload(window, std::move(newTables), std::move(rows));
}

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window, std::vector<OpticalTable> newTables,
  std::vector<glm::vec4> entries)
{
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
