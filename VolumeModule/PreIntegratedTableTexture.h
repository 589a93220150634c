#ifndef Varimarch_PreIntegratedTableTexture_h
#define Varimarch_PreIntegratedTableTexture_h

#include "Core/PreIntegratedTable.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A PreIntegratedTable on the device.
class PreIntegratedTableTexture
{
public:
  void Upload(vtkOpenGLRenderWindow* window, PreIntegratedTable table);

  vtkTextureObject* Texture() const { return this->texture; }
  int Size() const { return this->size; }
  std::size_t Bytes() const { return std::size_t(this->size) * this->size * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  int size = 0;
};

}

#endif
