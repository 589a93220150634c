#include "Resources/MaskTexture.h"

#include "Core/Fields/BrickRows.h"
#include "Resources/VolumeTexture.h"
#include "VtkVersions.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

std::uint16_t RowOf(double label, const MaskVoxels& mask)
{
  if (mask.binary)
  {
    return label > 0.0 ? 1 : 0;
  }
  const int rounded = int(std::lround(label));
  const auto found = std::lower_bound(mask.rows.begin(), mask.rows.end(), rounded);
  const bool hasRow = found != mask.rows.end() && *found == rounded;
  return std::uint16_t(hasRow ? found - mask.rows.begin() + 1 : 0);
}

std::vector<std::uint16_t> RowsOf(const MaskVoxels& mask)
{
  std::vector<std::uint16_t> rows(mask.labels->GetNumberOfTuples());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    rows[i] = RowOf(mask.labels->GetComponent(vtkIdType(i), 0), mask);
  }
  return rows;
}

std::vector<std::uint16_t> TexelsOf(const std::vector<std::uint16_t>& rows, const MaskVoxels& mask)
{
  const std::vector<std::uint16_t> reach = LabelReach(rows, mask.dimensions);
  std::vector<std::uint16_t> texels;
  texels.reserve(2 * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    texels.insert(texels.end(), { rows[i], reach[i] });
  }
  return texels;
}

}

void MaskTexture::Update(vtkOpenGLRenderWindow* window, const MaskVoxels& newMask,
  glm::ivec3 newBrickedVoxels, Marcher marcher)
{
  const bool isNew = !(this->mask == newMask && this->brickedVoxels == newBrickedVoxels);
  if (isNew)
  {
    this->Release(window);
    this->mask = newMask;
    this->brickedVoxels = newBrickedVoxels;
  }
  if (marcher == Marcher::Device && this->bytes > 0)
  {
    return;
  }
  if (this->texels.empty())
  {
    const std::vector<std::uint16_t> rowsOfVoxels = RowsOf(newMask);
    if (isNew && newBrickedVoxels != glm::ivec3(0))
    {
      this->rows = BrickRows(rowsOfVoxels, newMask.dimensions, newBrickedVoxels);
      ++this->builds;
    }
    this->texels = TexelsOf(rowsOfVoxels, newMask);
  }
  marcher == Marcher::Device ? this->Upload(window) : this->ReleaseTexture(window);
}

void MaskTexture::Upload(vtkOpenGLRenderWindow* window)
{
  const glm::ivec3 size = this->mask.dimensions;
  AllocateTexture3D(this->texture, window, size, VTK_UNSIGNED_SHORT, GL_RG16, 2, "a mask");
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size.x, size.y, size.z, GL_RG, GL_UNSIGNED_SHORT,
    this->texels.data());
  this->texture->Deactivate();
  this->bytes = this->texels.size() * sizeof(std::uint16_t);
  this->texels = {};
}

void MaskTexture::ReleaseTexture(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

void MaskTexture::Release(vtkWindow* window)
{
  this->ReleaseTexture(window);
  this->builds += this->rows.AreKnown() ? 1 : 0;
  this->rows = BrickRows();
  this->mask = {};
  this->texels = {};
}

}
