#ifndef Varimarch_OpticalTableTexture_h
#define Varimarch_OpticalTableTexture_h

#include "Core/TransferFunction.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A transfer function on the device: an OpticalTable in a buffer texture, so that the shader
/// interpolates it in full precision.
class OpticalTableTexture
{
public:
  void Upload(vtkOpenGLRenderWindow* window, const OpticalTable& table);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t EntryCount() const { return this->entryCount; }
  double FirstValue() const { return this->firstValue; }
  double LastValue() const { return this->lastValue; }
  std::size_t Bytes() const { return this->entryCount * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  std::size_t entryCount = 0;
  double firstValue = 0.0;
  double lastValue = 0.0;
};

}

#endif
