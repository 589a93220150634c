#ifndef Varimarch_Resources_MaskTexture_h
#define Varimarch_Resources_MaskTexture_h

#include "Core/Recipe/RenderSettings.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace varimarch
{

/// What a mask says of its voxels, which span the same box as those of the volume.
struct MaskVoxels
{
  vtkDataArray* labels = nullptr; ///< one component
  glm::ivec3 dimensions = glm::ivec3(0);
  vtkMTimeType time = 0; ///< when they changed last
  bool binary = false;
  std::vector<int> rows; ///< not binary: labels that have a row of their own; sorted

  bool operator==(const MaskVoxels& other) const
  {
    return this->labels == other.labels && this->time == other.time &&
      this->binary == other.binary && this->rows == other.rows;
  }
};

/// A mask: for each voxel its row, or whether it is drawn, and how far that is the same
/// (LabelReach), as Shaders/Mask reads them; on the device, or in memory where the processor
/// marches. It is whole where the volume is in blocks.
class MaskTexture
{
public:
  /// Takes a mask if it is another than the last, or elsewhere.
  /// @throws std::runtime_error when the device cannot hold it
  void Update(vtkOpenGLRenderWindow* window, const MaskVoxels& mask, Marcher marcher);

  vtkTextureObject* Texture() const { return this->texture; }
  const std::vector<std::uint16_t>& Texels() const { return this->texels; } ///< of the processor
  glm::ivec3 Size() const { return this->mask.dimensions; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseTexture(vtkWindow* window);

  MaskVoxels mask;
  std::vector<std::uint16_t> texels; ///< two of each voxel
  std::size_t bytes = 0;
};

}

#endif
