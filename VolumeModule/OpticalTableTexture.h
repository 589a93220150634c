#ifndef Varimarch_OpticalTableTexture_h
#define Varimarch_OpticalTableTexture_h

#include "Core/TransferFunction.h"
#include "FloatBufferTexture.h"

namespace varimarch
{

/// A transfer function on the device, as an OpticalTable.
class OpticalTableTexture
{
public:
  void Upload(vtkOpenGLRenderWindow* window, OpticalTable table);

  vtkTextureObject* Texture() const { return this->texture.Texture(); }
  const OpticalTable& Table() const { return this->table; }
  const std::array<double, 2>& VisibleValues() const { return this->visibleValues; }
  std::size_t Bytes() const { return this->texture.Bytes(); }
  void Release(vtkWindow* window);

private:
  FloatBufferTexture texture;
  OpticalTable table = {};
  std::array<double, 2> visibleValues = {};
};

}

#endif
