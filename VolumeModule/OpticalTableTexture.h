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
  void Upload(vtkOpenGLRenderWindow* window, OpticalTable table);

  vtkTextureObject* Texture() const { return this->texture; }
  const OpticalTable& Table() const { return this->table; }
  const std::array<double, 2>& VisibleValues() const { return this->visibleValues; }
  std::size_t Bytes() const { return this->table.entries.size() * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  OpticalTable table = {};
  std::array<double, 2> visibleValues = {};
};

}

#endif
