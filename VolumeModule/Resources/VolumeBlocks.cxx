#include "Resources/VolumeBlocks.h"

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

void VolumeBlock::Release(vtkWindow* window)
{
  this->volume.Release(window);
  this->gaps.Release(window);
  this->valueField.Release(window);
  this->gradients.Release(window);
}

void VolumeBlocks::SetVoxels(const VoxelValues& newValues)
{
  this->values = newValues;
  this->ForgetVoxels();
}

void VolumeBlocks::ForgetVoxels()
{
  for (const auto& block : this->blocks)
  {
    if (block)
    {
      block->isCurrent = false;
    }
  }
}

void VolumeBlocks::SetFilter(bool areFiltered8Bits)
{
  const TexelFormat present = this->Format();
  this->filters8Bits = areFiltered8Bits;
  if (this->Format() != present)
  {
    this->ForgetVoxels();
  }
}

void VolumeBlocks::SetBlanking(const Blanking& newBlanking)
{
  if (newBlanking == this->blanking)
  {
    return;
  }
  this->blanking = newBlanking;
  for (const auto& block : this->blocks)
  {
    if (block)
    {
      block->gapsAreCurrent = false;
    }
  }
}

void VolumeBlocks::SetValueField(vtkWindow* window, std::optional<ValueField> chosen)
{
  this->valueField = chosen;
  this->fieldBuildSeconds = 0.0;
  for (const auto& block : this->blocks)
  {
    if (block && !chosen)
    {
      block->valueField.Release(window);
      block->valueFieldOf.reset();
    }
  }
}

void VolumeBlocks::SetGradients(vtkWindow* window, bool areStored)
{
  this->storesGradients = areStored;
  for (const auto& block : this->blocks)
  {
    if (block && !areStored)
    {
      block->gradients.Release(window);
      block->gradientsAreCurrent = false;
    }
  }
}

std::size_t VolumeBlocks::BytesPerVoxel() const
{
  const std::size_t gapBytes = this->MayHaveGaps() ? 1 : 0;
  return this->values.texels.size() * BytesOf(this->Format()) + gapBytes +
    (this->valueField ? 1 : 0) + (this->storesGradients ? GradientTexture::BytesPerVoxel : 0);
}

bool VolumeBlocks::Divide(vtkWindow* window, const BlockLimits& limits)
{
  const BlockPartition divided(this->values.dimensions, limits);
  if (divided == this->partition)
  {
    return false;
  }
  this->Release(window);
  this->partition = divided;
  this->blocks.resize(divided.Count());
  return true;
}

void VolumeBlocks::BeginPicture(
  vtkWindow* window, const std::vector<int>& order, std::size_t capacity)
{
  this->capacity = capacity;
  this->residency.BeginPicture(order);
  this->LetGo(window, this->residency.Shrink(capacity));
}

void VolumeBlocks::LetGo(vtkWindow* window, const std::vector<int>& released)
{
  for (int block : released)
  {
    this->blocks[block]->Release(window);
    this->blocks[block].reset();
  }
}

const VolumeBlock& VolumeBlocks::Take(vtkOpenGLRenderWindow* window, int block)
{
  const ScalarRegion region{ this->values.components, this->values.dimensions,
    this->partition.VoxelsOf(block) };
  const glm::ivec3 count = region.voxels.count;
  const std::size_t bytes = this->BytesPerVoxel() * count.x * count.y * count.z;
  std::vector<int> released = this->residency.Use(block, bytes, this->capacity);
  std::unique_ptr<VolumeBlock>& taken = this->blocks[block];
  if (!taken && !released.empty())
  {
    // A released block's textures are reused, because they often have the same size.
    taken = std::move(this->blocks[released.back()]);
    taken->isCurrent = false;
    released.pop_back();
  }
  this->LetGo(window, released);
  if (!taken)
  {
    taken = std::make_unique<VolumeBlock>();
  }
  if (!taken->isCurrent)
  {
    this->Upload(window, *taken, region);
  }
  this->UpdateGaps(window, *taken, region);
  this->UpdateValueField(window, *taken, region);
  this->UpdateGradients(window, *taken, region);
  return *taken;
}

void VolumeBlocks::Upload(
  vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region)
{
  block.valueFieldOf.reset();
  block.volume.Upload(window, region, this->values.texels, this->Format());
  block.isCurrent = true;
  block.gapsAreCurrent = false;
  block.gradientsAreCurrent = false;
  ++this->uploads;
}

void VolumeBlocks::UpdateGaps(
  vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region)
{
  if (block.gapsAreCurrent)
  {
    return;
  }
  if (block.volume.AllFinite() && !this->blanking.Any())
  {
    block.gaps.Release(window);
  }
  else
  {
    const GapField gaps = GapFieldOf(region, this->blanking);
    block.gaps.SetTexels(window, gaps.count, gaps.texels);
  }
  block.gapsAreCurrent = true;
}

void VolumeBlocks::UpdateValueField(
  vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region)
{
  if (this->valueField && !(block.valueFieldOf == this->valueField))
  {
    block.valueField.BuildValueField(window, region, *this->valueField, this->values.reachVoxels);
    block.valueFieldOf = this->valueField;
    this->fieldBuildSeconds += block.valueField.BuildSeconds();
  }
}

void VolumeBlocks::UpdateGradients(
  vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region)
{
  if (this->storesGradients && !block.gradientsAreCurrent)
  {
    block.gradients.Upload(window, region, this->Texels());
    block.gradientsAreCurrent = true;
  }
}

std::size_t VolumeBlocks::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& block : this->blocks)
  {
    bytes += block ? block->Bytes() : 0;
  }
  return bytes;
}

void VolumeBlocks::Release(vtkWindow* window)
{
  for (const auto& block : this->blocks)
  {
    if (block)
    {
      block->Release(window);
    }
  }
  this->blocks.clear();
  this->residency.Clear();
  this->partition = BlockPartition();
}

}
