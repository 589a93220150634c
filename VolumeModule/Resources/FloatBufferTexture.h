#ifndef Varimarch_Resources_FloatBufferTexture_h
#define Varimarch_Resources_FloatBufferTexture_h

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

}

#endif
