#include "Resources/GradientTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace varimarch
{

namespace
{

// The texels of some slices of a region, with one slice to either side where there is one.
struct Slab
{
  glm::ivec3 count; ///< The size of the region.
  int firstSlice;   ///< The slice of the region that is the first in `texels`.
  std::vector<float> texels;

  float At(glm::ivec3 voxel) const
  {
    const glm::ivec3 inside = glm::clamp(voxel, glm::ivec3(0), this->count - 1);
    const std::size_t slice = std::size_t(inside.z - this->firstSlice);
    return this->texels[(slice * this->count.y + inside.y) * this->count.x + inside.x];
  }
};

Slab SlabAround(const ScalarRegion& region, const ScalarTexels& texels, int slice, int slices)
{
  const glm::ivec3 count = region.voxels.count;
  const int first = std::max(slice - 1, 0);
  const int last = std::min(slice + slices, count.z - 1);
  ScalarRegion part = region;
  part.voxels.first.z += first;
  part.voxels.count.z = last - first + 1;
  return { count, first, TexelsAsFloats(part, texels) };
}

std::vector<glm::vec3> Differences(const Slab& slab, int slice, int slices)
{
  const glm::ivec3 count = slab.count;
  std::vector<glm::vec3> differences(std::size_t(count.x) * count.y * slices);
  tbb::parallel_for(0, count.y * slices,
    [&](int row)
    {
      const glm::ivec3 first(0, row % count.y, slice + row / count.y);
      for (int x = 0; x < count.x; ++x)
      {
        const glm::ivec3 voxel = first + glm::ivec3(x, 0, 0);
        glm::vec3& difference = differences[std::size_t(row) * count.x + x];
        for (int axis = 0; axis < 3; ++axis)
        {
          glm::ivec3 side(0);
          side[axis] = 1;
          difference[axis] = slab.At(voxel + side) - slab.At(voxel - side);
        }
      }
    });
  return differences;
}

}

// A few slices at a time, so that memory never holds all gradients.
void GradientTexture::Upload(
  vtkOpenGLRenderWindow* window, const ScalarRegion& region, const ScalarTexels& texels)
{
  constexpr std::size_t VoxelsAtOnce = std::size_t(1) << 20;
  const glm::ivec3 count = region.voxels.count;
  AllocateTexture3D(this->texture, window, count, VTK_FLOAT,
    texels.normalized ? GL_RGB16_SNORM : GL_RGB16F, 3, "the gradients of a volume");
  this->bytes = BytesPerVoxel * count.x * count.y * count.z;
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const int slicesAtOnce = int(std::max(VoxelsAtOnce / count.x / count.y, std::size_t(1)));
  for (int slice = 0; slice < count.z; slice += slicesAtOnce)
  {
    const int slices = std::min(slicesAtOnce, count.z - slice);
    const std::vector<glm::vec3> differences =
      Differences(SlabAround(region, texels, slice, slices), slice, slices);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, count.x, count.y, slices, GL_RGB, GL_FLOAT,
      differences.data());
  }
  this->texture->Deactivate();
}

void GradientTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
