#include "Resources/GradientTexture.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace varimarch
{

namespace
{

// The texels of a part of a volume.
struct Slab
{
  glm::ivec3 dimensions; ///< The size of the volume.
  VoxelRegion voxels;    ///< The part.
  std::vector<float> texels;

  // The value of a voxel of the volume, which continues outside.
  float At(glm::ivec3 voxel) const
  {
    const glm::ivec3 inside =
      glm::clamp(voxel, glm::ivec3(0), this->dimensions - 1) - this->voxels.first;
    const glm::ivec3& count = this->voxels.count;
    return this->texels[(std::size_t(inside.z) * count.y + inside.y) * count.x + inside.x];
  }
};

// A part of a volume with the voxels beside it, so that blocks have the gradients of the whole.
Slab SlabAround(const ScalarRegion& region, const VoxelRegion& voxels, const ScalarTexels& texels)
{
  const glm::ivec3 lower = glm::max(voxels.first - 1, glm::ivec3(0));
  const glm::ivec3 upper = glm::min(voxels.first + voxels.count + 1, region.dimensions);
  ScalarRegion part = region;
  part.voxels = { lower, upper - lower };
  return { region.dimensions, part.voxels, TexelsAsFloats(part, texels) };
}

std::vector<glm::vec3> Differences(const Slab& slab, const VoxelRegion& voxels)
{
  const glm::ivec3& count = voxels.count;
  std::vector<glm::vec3> differences(std::size_t(count.x) * count.y * count.z);
  tbb::parallel_for(0, count.y * count.z,
    [&](int row)
    {
      const glm::ivec3 first = voxels.first + glm::ivec3(0, row % count.y, row / count.y);
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
    const VoxelRegion voxels{ region.voxels.first + glm::ivec3(0, 0, slice),
      { count.x, count.y, slices } };
    const std::vector<glm::vec3> differences =
      Differences(SlabAround(region, voxels, texels), voxels);
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
