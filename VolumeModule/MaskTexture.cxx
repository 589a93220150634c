#include "MaskTexture.h"

#include "Core/LabelReach.h"
#include "VolumeTexture.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

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

}

void MaskTexture::Update(vtkOpenGLRenderWindow* window, const MaskVoxels& newMask)
{
  if (this->mask == newMask)
  {
    return;
  }
  std::vector<std::uint16_t> rows(newMask.labels->GetNumberOfTuples());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    rows[i] = RowOf(newMask.labels->GetComponent(vtkIdType(i), 0), newMask);
  }
  const std::vector<std::uint16_t> reach = LabelReach(rows, newMask.dimensions);
  std::vector<std::uint16_t> texels;
  texels.reserve(2 * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    texels.insert(texels.end(), { rows[i], reach[i] });
  }
  const glm::ivec3 size = newMask.dimensions;
  AllocateTexture3D(this->texture, window, size, VTK_UNSIGNED_SHORT, GL_RG16, 2, "a mask");
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(
    GL_TEXTURE_3D, 0, 0, 0, 0, size.x, size.y, size.z, GL_RG, GL_UNSIGNED_SHORT, texels.data());
  this->texture->Deactivate();
  this->bytes = texels.size() * sizeof(std::uint16_t);
  this->mask = newMask;
  ++this->builds;
}

void MaskTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->mask = {};
  this->bytes = 0;
}

}
