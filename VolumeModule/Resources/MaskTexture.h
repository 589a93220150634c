#ifndef Varimarch_Resources_MaskTexture_h
#define Varimarch_Resources_MaskTexture_h

#include "Core/Parameters/MarchTextures.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/VoxelInput.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A mask. Each voxel has its row, or 1 if it is drawn, and the distance within which this value is
/// the same (LabelReach), as Shaders/Mask reads them. The mask is on the device, or in memory if
/// the processor marches, and is not divided even if the volume is in blocks.
class MaskTexture
{
public:
  /// Updates the texels if the mask or the marcher that reads them has changed.
  /// @throws std::runtime_error if the device cannot hold the texture
  void Update(vtkOpenGLRenderWindow* window, const MaskVoxels& mask, Marcher marcher);

  MarchTexture Texture() const
  {
    return { this->texture, this->texels.empty() ? nullptr : this->texels.data() };
  }
  glm::ivec3 Size() const { return this->mask.dimensions; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseTexture(vtkWindow* window);

  MaskVoxels mask;
  std::vector<std::uint16_t> texels; ///< Two numbers for each voxel.
  std::size_t bytes = 0;
};

}

#endif
