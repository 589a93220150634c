#ifndef Varimarch_Resources_MaskTexture_h
#define Varimarch_Resources_MaskTexture_h

#include "Core/Fields/BrickRows.h"
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
  /// @param brickedVoxels  the number of the volume's voxels along each axis; 0 if its bricks do
  ///                       not have the places of voxels, as on uneven axes
  /// @throws std::runtime_error if the device cannot hold the texture
  void Update(vtkOpenGLRenderWindow* window, const MaskVoxels& mask, glm::ivec3 brickedVoxels,
    Marcher marcher);

  MarchTexture Texture() const
  {
    return { this->texture, this->texels.empty() ? nullptr : this->texels.data() };
  }
  /// The rows in each brick of the volume. All are possible without a mask.
  const BrickRows& Rows() const { return this->rows; }
  int Builds() const { return this->builds; } ///< The number of changes of Rows() so far.
  glm::ivec3 Size() const { return this->mask.dimensions; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseTexture(vtkWindow* window);

  MaskVoxels mask;
  glm::ivec3 brickedVoxels = glm::ivec3(0);
  BrickRows rows;
  int builds = 0;
  std::vector<std::uint16_t> texels; ///< Two numbers for each voxel.
  std::size_t bytes = 0;
};

}

#endif
