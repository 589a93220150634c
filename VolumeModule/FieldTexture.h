#ifndef Varimarch_FieldTexture_h
#define Varimarch_FieldTexture_h

#include "Core/VariationField.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The variation field of a volume as a 3D texture, one byte per cell.
class FieldTexture
{
public:
  /// Builds the field on the CPU and uploads it.
  /// @param tolerance  see BuildVariationField
  /// @throws std::runtime_error when the device cannot hold the texture
  void Build(
    vtkOpenGLRenderWindow* window, vtkDataArray* scalars, glm::ivec3 dimensions, double tolerance);

  vtkTextureObject* Texture() const { return this->texture; }
  glm::ivec3 CellCount() const { return this->cellCount; }
  double BuildSeconds() const { return this->buildSeconds; } ///< without the upload
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  glm::ivec3 cellCount = glm::ivec3(1);
  double buildSeconds = 0.0;
  std::size_t bytes = 0;
};

}

#endif
