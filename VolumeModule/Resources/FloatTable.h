#ifndef Varimarch_Resources_FloatTable_h
#define Varimarch_Resources_FloatTable_h

#include "Core/Parameters/MarchTextures.h"
#include "Core/Recipe/RenderSettings.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A table of four floats per entry in a buffer texture. The shader interpolates in full precision,
/// because the weights of texture filters have only 8 bits on most hardware.
class FloatBufferTexture
{
public:
  /// @param entries  at least one
  void Upload(vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& entries);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const { return this->count * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  std::size_t count = 0;
};

/// A table of four floats per entry in memory, and in a buffer texture if the device marches.
class FloatTable
{
public:
  /// Replaces the entries, unless they are the same.
  /// @param entries  the entries; may be empty
  void Set(vtkWindow* window, std::vector<glm::vec4> entries);

  /// Uploads the texture for the device, or releases it for the processor.
  void Update(vtkOpenGLRenderWindow* window, Marcher marcher);

  MarchTexture Texture() const;
  std::size_t Bytes() const { return this->texture.Bytes(); } ///< The graphics memory of the table.
  void Release(vtkWindow* window) { this->Set(window, {}); }

private:
  FloatBufferTexture texture;
  std::vector<glm::vec4> entries;
};

}

#endif
