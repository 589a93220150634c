#include "Resources/OpticalTableTexture.h"

#include <algorithm>
#include <utility>

namespace varimarch
{

void OpticalTableTexture::SetTables(vtkWindow* window, std::vector<OpticalTable> newTables)
{
  this->ReleaseTexture(window);
  this->tables = std::move(newTables);
  this->visibleValues.clear();
  for (const OpticalTable& table : this->tables)
  {
    this->visibleValues.push_back(varimarch::VisibleValues(table));
  }
}

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->Bytes() == 0)
  {
    this->UploadBehind(window, {});
  }
}

void OpticalTableTexture::UploadRows(vtkOpenGLRenderWindow* window, const TexelMapping& mapping)
{
  if (this->Bytes() > 0)
  {
    return;
  }
  std::vector<glm::vec4> rows;
  std::size_t first = this->tables.size();
  for (const OpticalTable& table : this->tables)
  {
    const double last = double(table.entries.size() - 1);
    const IndexInTable index = IndexOf(table, last, mapping.scale, mapping.offset);
    rows.emplace_back(index.scale, index.bias, double(first), last);
    first += table.entries.size();
  }
  this->UploadBehind(window, std::move(rows));
}

void OpticalTableTexture::UploadBehind(
  vtkOpenGLRenderWindow* window, std::vector<glm::vec4> entries)
{
  for (const OpticalTable& table : this->tables)
  {
    entries.insert(entries.end(), table.entries.begin(), table.entries.end());
  }
  this->texture.Upload(window, entries);
}

std::array<double, 2> OpticalTableTexture::VisibleValuesOfAny() const
{
  std::array<double, 2> any = this->visibleValues.front();
  for (const std::array<double, 2>& values : this->visibleValues)
  {
    any = { std::min(any[0], values[0]), std::max(any[1], values[1]) };
  }
  return any;
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
  this->ReleaseTexture(window);
  this->tables = { OpticalTable() };
}

}
